#pragma once

#include <cstddef>
#include <memory>
#include <stop_token>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/layout.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::search {

/// Where and how finely the leg cost model is gridded to judge a route. All values are rounded to lattices,
/// so similar routes have the same site and share one model. The site depends on route and request alone, so
/// the results for a route do not depend on the routes judged before.
struct RouteSite {
  geo::LonLat origin;  // of the plane
  plane::PlaneBox area;
  core::Metres cell;    // of the safety map
  core::Seconds drift;  // drift of the icebergs is computed for at least this time
  std::vector<geo::LonLat>
      ends;  // ends of the route, if the vehicle may pass under icebergs: the route must not end below one

  friend bool operator==(const RouteSite&, const RouteSite&) = default;
};

/// The request for a direct route through these places. There must be at least two.
/// Errors   std::invalid_argument for fewer places and for an invalid request
[[nodiscard]] PlanRequest request_along(const std::vector<geo::LonLat>& route, const PlanRequest& request);

/// The extent of the grid beside a given route. A given route needs no room for a search, only for the
/// fastest route in open water that it is compared with, which bends with the currents. So the grid is small
/// and quick. Escape routes are searched for, so requests with escape routes get more room.
[[nodiscard]] cost::GridReach reach_beside(const PlanRequest& request);

/// The site of a request that `request_along` returned.
[[nodiscard]] RouteSite site_of(const PlanRequest& on_route);

/// The leg cost model of a site. It is made once for all routes of the site whose requests differ only in
/// their places.
/// Threads  const members may be called from several threads at once
class RouteGround {
 public:
  /// `on_route` is one of those requests, `site` its site. Once `stop` is requested the object stays
  /// incomplete and must not be used. `shelf`: see `Sea`.
  RouteGround(ocean::Environment environment, const PlanRequest& on_route, RouteSite site,
              const std::stop_token& stop, cost::SeaShelf* shelf = nullptr);
  RouteGround(const RouteGround&) = delete;
  RouteGround& operator=(const RouteGround&) = delete;

  /// The environment without its currents and wind: the model holds its own gridded copies of them.
  [[nodiscard]] const ocean::Environment& environment() const { return environment_; }
  [[nodiscard]] const RouteSite& site() const { return site_; }
  [[nodiscard]] const geo::LocalProjection& projection() const { return sea_.domain().projection(); }
  /// A copy that borrows this object.
  [[nodiscard]] const cost::Sea& sea() const { return sea_; }
  /// Memory in bytes of the grids and of the data kept with them.
  [[nodiscard]] std::size_t bytes() const;

 private:
  ocean::Environment environment_;
  RouteSite site_;
  cost::Sea sea_;
};

/// `shelf`: see `Sea`.
/// Errors   Reason::too_large for too many icebergs; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<std::shared_ptr<const RouteGround>> lay_out_ground(ocean::Environment environment,
                                                                        const PlanRequest& on_route,
                                                                        const RouteSite& site,
                                                                        const std::stop_token& stop,
                                                                        cost::SeaShelf* shelf = nullptr);

}  // namespace floeplan::planning::search

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

/// Where and how finely the leg cost model is gridded to judge a route. Everything lies on lattices, so similar
/// routes have the same site. It follows from route and request alone, so the figures of a route do not depend on
/// which routes were judged before.
struct RouteSite {
  geo::LonLat origin;  // of the plane
  plane::PlaneBox area;
  core::Metres cell;    // of the safety map
  core::Seconds drift;  // least drift of the icebergs
  std::vector<geo::LonLat>
      ends;  // of the route, if icebergs may be passed under: the route must not end within one

  friend bool operator==(const RouteSite&, const RouteSite&) = default;
};

/// The request for a direct route along these places, at least two.
/// Errors   std::invalid_argument for fewer places and for an invalid request
[[nodiscard]] PlanRequest request_along(const std::vector<geo::LonLat>& route, const PlanRequest& request);

/// The extent of the grid beside a given route. It needs no room for a search, only for the fastest route in open
/// water with which it is compared and which bends with the currents. That takes a fraction of the work. Escape
/// routes are searched for, so they need room.
[[nodiscard]] cost::GridReach reach_beside(const PlanRequest& request);

/// `on_route`: as `request_along` gives it.
[[nodiscard]] RouteSite site_of(const PlanRequest& on_route);

/// The leg cost model of a site, made once for all routes of this site whose requests differ in their places alone.
/// Threads  const members may be called from several threads at once
class RouteGround {
 public:
  /// `on_route` is one of those requests, `site` its site. Once `stop` is requested the object stays incomplete and
  /// must not be used.
  RouteGround(ocean::Environment environment, const PlanRequest& on_route, RouteSite site,
              const std::stop_token& stop);
  RouteGround(const RouteGround&) = delete;
  RouteGround& operator=(const RouteGround&) = delete;

  /// The environment without its currents and wind, which the model has taken over.
  [[nodiscard]] const ocean::Environment& environment() const { return environment_; }
  [[nodiscard]] const RouteSite& site() const { return site_; }
  [[nodiscard]] const geo::LocalProjection& projection() const { return sea_.domain().projection(); }
  /// A copy that borrows this object.
  [[nodiscard]] const cost::Sea& sea() const { return sea_; }
  /// Memory of everything large: the grids and the data kept with them.
  [[nodiscard]] std::size_t bytes() const;

 private:
  ocean::Environment environment_;
  RouteSite site_;
  cost::Sea sea_;
};

/// Errors   Reason::too_large for too many icebergs; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<std::shared_ptr<const RouteGround>> lay_out_ground(ocean::Environment environment,
                                                                        const PlanRequest& on_route,
                                                                        const RouteSite& site,
                                                                        const std::stop_token& stop);

}  // namespace floeplan::planning::search

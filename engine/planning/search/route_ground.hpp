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

/// Where and how finely the sea is laid out to judge a route. Everything lies on lattices, so that routes that differ
/// little have the same site; it follows from route and request alone, so that a route's figures do not depend on which
/// routes were judged before it.
struct RouteSite {
  geo::LonLat origin;  // of the plane
  plane::PlaneBox area;
  core::Metres cell;              // of the safety map
  core::Seconds drift;            // how long icebergs drift at least
  std::vector<geo::LonLat> ends;  // of the route, where icebergs are passed under: not where one of them lies

  friend bool operator==(const RouteSite&, const RouteSite&) = default;
};

/// The request for a direct way along the route, which has at least two places.
/// Errors   std::invalid_argument for a shorter route and for an invalid request
[[nodiscard]] PlanRequest request_along(const std::vector<geo::LonLat>& route, const PlanRequest& request);

/// A route that is given needs no room for a search, only for the fastest way in open water that it is compared with,
/// which bends with the currents: it is a fraction of the work to lay out that much. Ways of escape are searched for.
[[nodiscard]] cost::GridReach reach_beside(const PlanRequest& request);

/// `on_route`: as `request_along` gives it.
[[nodiscard]] RouteSite site_of(const PlanRequest& on_route);

/// The sea of a site, laid out once for all routes that have this site and requests that differ in their places alone.
/// Threads  const members may be called from several threads at once
class RouteGround {
 public:
  /// `on_route` is one of those requests, `site` its site. Once `stop` is requested the ground stays incomplete and
  /// must not be used.
  RouteGround(ocean::Environment environment, const PlanRequest& on_route, RouteSite site,
              const std::stop_token& stop);
  RouteGround(const RouteGround&) = delete;
  RouteGround& operator=(const RouteGround&) = delete;

  /// Without its currents and its wind, which the sea has taken over.
  [[nodiscard]] const ocean::Environment& environment() const { return environment_; }
  [[nodiscard]] const RouteSite& site() const { return site_; }
  [[nodiscard]] const geo::LocalProjection& projection() const { return sea_.projection(); }
  /// A copy borrows the ground.
  [[nodiscard]] const cost::Sea& sea() const { return sea_; }
  /// Memory of all that is large: what is laid out, and the data that are kept with it.
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

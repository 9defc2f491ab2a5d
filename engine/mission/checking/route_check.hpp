#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::mission {

/// Something that the sea does to a route.
struct RouteFinding {
  std::size_t place{};  // index into the route: where the leg leads to, or the place itself
  bool dangerous{};     // the vehicle may be lost; otherwise it is not known, or merely worth a look
  std::string code;     // a reason of planning::reason_name, or that of a row of the catalogue
  std::string text;
};

struct RouteCheck {
  std::vector<RouteFinding> findings;
  std::optional<planning::Plan> timing;  // of the whole route, when nothing closes it
  std::vector<std::size_t>
      places;  // of the route, for each waypoint of `timing`: those that repeat have none
};

/// How a mission dives, as far as its files say.
struct DiveArguments {
  core::Metres target_depth{};
  bool altimeter{true};     // heeds the sea bed; false for a negative d_target_altitude
  core::Metres altitude{};  // above the bed that it turns at if it does
  core::Metres climb_to{};  // it turns no higher
  bool on_thruster{false};  // down and up
};

/// Follows a route through the sea at the times at which the vehicle is on it, and names every leg that is closed
/// by land, depth, ice, icebergs, zones or current. After a closed leg it goes on from that leg's end, at the time
/// at which the vehicle would have been there in still water.
/// `request`  departure, vehicle and margins; its places are ignored
/// Edges      fewer than two different places: no finding. At most 20 findings.
/// Errors     std::invalid_argument for places off the Earth
[[nodiscard]] RouteCheck check_route(const ocean::Environment& environment,
                                     const std::vector<geo::LonLat>& route,
                                     const planning::PlanRequest& request);

/// Legs on which a vehicle that does not heed the sea bed dives into it, or that leave the yo no room to turn above the
/// bed below the depth that it climbs to.
/// Accuracy   the bed is looked up every 250 m
[[nodiscard]] std::vector<RouteFinding> check_depths(const ocean::Environment& environment,
                                                     const std::vector<geo::LonLat>& route,
                                                     const DiveArguments& dive);

}  // namespace floeplan::mission

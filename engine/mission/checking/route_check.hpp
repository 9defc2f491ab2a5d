#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::mission {

/// One finding of `check_route` or `check_depths` about a leg or a place.
struct RouteFinding {
  std::size_t place{};  // index into the route: end of the leg, or the place itself
  bool dangerous{};     // true: the vehicle may be lost; false: unknown, or worth a look
  std::string code;     // reason (planning::reason_name), or code of a message of the catalogue
  std::string text;
};

struct RouteCheck {
  std::vector<RouteFinding> findings;
  std::optional<planning::Plan> timing;  // of the whole route, if nothing closes it
  std::vector<std::size_t>
      places;  // index into the route for each waypoint of `timing`; repeated places have none
};

/// The dives of a mission, as far as its files give them.
struct DiveArguments {
  core::Metres target_depth{};
  bool altimeter{true};     // turns above the sea bed; false for a negative d_target_altitude
  core::Metres altitude{};  // distance to the bed at which it turns, if so
  core::Metres climb_to{};  // upper turn
  bool on_thruster{false};  // thruster on, for dives and climbs
};

/// Follows a route at the times at which the vehicle is on it. Reports every leg that is closed by land,
/// depth, ice, icebergs, zones or current. After a closed leg it continues from that leg's end, at the time
/// of arrival in still water.
/// `request`  departure, vehicle and margins; its places are ignored
/// Edges      fewer than two different places: no finding. At most 20 findings.
/// Errors     std::invalid_argument for invalid places
[[nodiscard]] RouteCheck check_route(const ocean::Environment& environment,
                                     const std::vector<geo::LonLat>& route,
                                     const planning::PlanRequest& request);

/// Finds legs on which a vehicle without altimeter dives into the sea bed, and legs on which the yo has no
/// room to turn between the bed and its upper turn.
/// Accuracy   the bed is sampled every 250 m
[[nodiscard]] std::vector<RouteFinding> check_depths(const ocean::Environment& environment,
                                                     const std::vector<geo::LonLat>& route,
                                                     const DiveArguments& dive);

}  // namespace floeplan::mission

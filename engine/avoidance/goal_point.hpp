#pragma once

#include <optional>
#include <span>

#include "engine/avoidance/mission_route.hpp"
#include "engine/avoidance/obstacles.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/avoidance/water_frame.hpp"

namespace floeplan::avoidance {

/// The rendezvous with the planned route behind the obstacles: the first place along it that is clear when the vehicle
/// can be there, beyond the last that is not, and at least `least_along_m` on. Empty: no such place within reach of the
/// path planner, or nothing is left of the route.
[[nodiscard]] std::optional<RoutePlace> rendezvous(const MissionRoute& route, const Going& going,
                                                   const WaterFrame& water,
                                                   std::span<const Obstacle> obstacles,
                                                   const AvoidanceSettings& settings, double least_along_m);

/// How far along the route a rendezvous is looked for.
inline constexpr double farthest_rendezvous_m = 900.0;

}  // namespace floeplan::avoidance

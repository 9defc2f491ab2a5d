#pragma once

#include <optional>
#include <span>

#include "engine/avoidance/mission_route.hpp"
#include "engine/avoidance/obstacles.hpp"
#include "engine/avoidance/settings.hpp"
#include "engine/avoidance/water_frame.hpp"

namespace floeplan::avoidance {

/// The place where the evasive way returns to the planned route behind the obstacles: the first place along
/// the route that is clear when the vehicle can be there. It lies beyond the last covered place and at least
/// `least_along_m` ahead. Empty: no such place within reach of path planning, or the route is finished.
[[nodiscard]] std::optional<RoutePlace> rendezvous(const MissionRoute& route, const Going& going,
                                                   const WaterFrame& water,
                                                   std::span<const Obstacle> obstacles,
                                                   const AvoidanceSettings& settings, double least_along_m);

/// Largest distance along the route at which a rendezvous is searched.
inline constexpr double farthest_rendezvous_m = 900.0;

}  // namespace floeplan::avoidance

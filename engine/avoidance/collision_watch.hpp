#pragma once

#include <optional>
#include <span>

#include "engine/avoidance/obstacles.hpp"
#include "engine/avoidance/timed_way.hpp"

namespace floeplan::avoidance {

/// The first time at which a vehicle on this way is nearer than `clearance_m` to an obstacle; empty: never,
/// up to the way's end. If it is nearer already, contact counts only where the way leads still nearer.
/// Exact    computed from moves and moving discs, not from samples
[[nodiscard]] std::optional<double> first_contact(std::span<const TimedPoint> way,
                                                  std::span<const Obstacle> obstacles, double clearance_m);

}  // namespace floeplan::avoidance

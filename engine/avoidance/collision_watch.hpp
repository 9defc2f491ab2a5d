#pragma once

#include <optional>
#include <span>

#include "engine/avoidance/obstacles.hpp"
#include "engine/avoidance/timed_way.hpp"

namespace floeplan::avoidance {

/// The first time at which someone who moves along the way is nearer than `clearance_m` to an obstacle; empty: never up
/// to the way's end. Who is nearer already is in contact only where the way leads still nearer.
/// Exact    the moves against the moving discs, not samples
[[nodiscard]] std::optional<double> first_contact(std::span<const TimedPoint> way,
                                                  std::span<const Obstacle> obstacles, double clearance_m);

}  // namespace floeplan::avoidance

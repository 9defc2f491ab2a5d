#pragma once

#include <tl/expected.hpp>

#include "engine/core/units.hpp"
#include "engine/geo/bearing.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/motion/edge_closed.hpp"

namespace floeplan::motion {

/// Speed over ground of a glider that crabs against `current` to hold `course` (navigation triangle).
/// Error    current_too_strong when no heading holds the course
/// Source   v = c.e + sqrt(V^2 - (c.n)^2), e along the course and n across it; Eichhorn 2009, section III.C
[[nodiscard]] tl::expected<core::MetresPerSecond, EdgeClosed> speed_over_ground(
    core::MetresPerSecond through_water, geo::VelocityEn current, geo::Bearing course);

}  // namespace floeplan::motion

#pragma once

#include <cstddef>
#include <limits>
#include <stop_token>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// Joins legs that run on in the same direction, at most so many to one; the way is the same.
[[nodiscard]] Route join_collinear(const Route& route,
                                   std::size_t most = std::numeric_limits<std::size_t>::max());

/// Takes out points as long as the arrival does not become later, or until `stop` is requested.
[[nodiscard]] Route drop_needless_points(const Sea& sea, const Route& route, core::Seconds depart,
                                         const std::stop_token& stop = {});

/// Parts every leg that is longer than `longest` into equal ones; the way is the same.
[[nodiscard]] Route part_long_legs(const Sea& sea, const Route& route, core::Metres longest);

}  // namespace floeplan::planning::cost

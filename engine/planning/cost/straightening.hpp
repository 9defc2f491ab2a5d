#pragma once

#include <cstddef>
#include <limits>
#include <stop_token>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/sea.hpp"

namespace floeplan::planning::cost {

/// Joins consecutive legs of the same direction, at most `most` to one leg. The line of the route does not
/// change.
[[nodiscard]] Route join_collinear(const Route& route,
                                   std::size_t most = std::numeric_limits<std::size_t>::max());

/// Removes points whose removal does not make the arrival later. Stops early once `stop` is requested.
[[nodiscard]] Route drop_needless_points(const Sea& sea, const Route& route, core::Seconds depart,
                                         const std::stop_token& stop = {});

/// Divides every leg longer than `longest` into equal legs. The line of the route does not change.
[[nodiscard]] Route part_long_legs(const PlanningDomain& domain, const Route& route, core::Metres longest);

}  // namespace floeplan::planning::cost

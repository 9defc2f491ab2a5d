#pragma once

#include <optional>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/carried_way.hpp"

namespace floeplan::planning::cost {

/// On the way from one look to the next, with the current half way; none where no current is known.
[[nodiscard]] CarriedWay carried_between(const Sea& sea, const Sea::Passage& from, const Sea::Passage& to);

/// Mean over each leg of the currents that the vehicle meets on it, averaged over the depths it dives to; empty for the
/// start, and everywhere where no currents are known. One for each point of the route.
[[nodiscard]] std::vector<std::optional<geo::VelocityEn>> leg_currents(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, const Schedule& schedule,
    const std::vector<vehicle::Drive>& drives);

}  // namespace floeplan::planning::cost

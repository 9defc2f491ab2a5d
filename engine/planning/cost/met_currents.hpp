#pragma once

#include <optional>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/carried_way.hpp"

namespace floeplan::planning::cost {

/// How far the current carries the vehicle between two passages, with the current at the middle; zero where it is
/// unknown.
[[nodiscard]] CarriedWay carried_between(const Sea& sea, const Sea::Passage& from, const Sea::Passage& to);

/// Mean of the currents that the vehicle meets on each leg, averaged over the depths of its dives. One value for each
/// point of the route; empty for the start, and where no currents are known.
[[nodiscard]] std::vector<std::optional<geo::VelocityEn>> leg_currents(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, const Schedule& schedule,
    const std::vector<vehicle::Drive>& drives);

}  // namespace floeplan::planning::cost

#pragma once

#include <optional>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/geo/velocity.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/carried_way.hpp"

namespace floeplan::planning::cost {

/// Displacement by the current between two passages. It uses the current half-way between them; zero where
/// the current is unknown.
[[nodiscard]] CarriedWay carried_between(const Sea& sea, const Sea::Passage& from, const Sea::Passage& to);

/// Mean current on each leg, averaged over the time of the leg and the depths of its dives. One value for
/// each point of the route, for the leg that ends there; empty for the start and where currents are unknown.
[[nodiscard]] std::vector<std::optional<geo::VelocityEn>> leg_currents(
    const Sea& sea, const std::vector<geo::PlanePoint>& route, const Schedule& schedule,
    const std::vector<vehicle::Drive>& drives);

}  // namespace floeplan::planning::cost

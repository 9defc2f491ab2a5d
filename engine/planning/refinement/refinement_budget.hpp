#pragma once

#include <stop_token>

#include "engine/core/clock.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/refinement/leg_meter.hpp"

namespace floeplan::planning::refinement {

/// Legs of the least time for each second that refinement may take: so few that hardly any machine runs out of time
/// first, and the same request gives the same route everywhere.
inline constexpr double timed_legs_per_second = 200'000.0;
/// The same where what a leg draws is counted, on each drive in turn.
inline constexpr double metered_legs_per_second = 30'000.0;

/// What the request leaves to refinement from now on.
/// `clock`  borrowed by the budget; empty: only evaluations count
[[nodiscard]] RefinementBudget refinement_budget(const PlanRequest& request, double legs_per_second,
                                                 const std::stop_token& stop, const core::SteadyClock& clock);

}  // namespace floeplan::planning::refinement

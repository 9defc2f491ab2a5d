#pragma once

#include <stop_token>

#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/refinement/leg_meter.hpp"

namespace floeplan::planning::refinement {

/// Legs of the least time that refinement may time for each second of `refine_time`: about what a machine of 2020 does.
inline constexpr double timed_legs_per_second = 200'000.0;
/// The same where what a leg draws is counted, on each drive in turn.
inline constexpr double metered_legs_per_second = 30'000.0;

/// What the request leaves to refinement.
[[nodiscard]] RefinementBudget refinement_budget(const PlanRequest& request, double legs_per_second,
                                                 const std::stop_token& stop);

}  // namespace floeplan::planning::refinement

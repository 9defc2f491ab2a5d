#pragma once

#include <stop_token>

#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/refinement/leg_meter.hpp"

namespace floeplan::planning::refinement {

/// Legs that refinement may time, by travel time alone, per second of `refine_time`: about the speed of a machine of
/// 2020.
inline constexpr double timed_legs_per_second = 200'000.0;
/// Legs that refinement may time per second of `refine_time` if energy counts, too, for each kind of
/// propulsion.
inline constexpr double metered_legs_per_second = 30'000.0;

/// The budget that the request gives to refinement.
[[nodiscard]] RefinementBudget refinement_budget(const PlanRequest& request, double legs_per_second,
                                                 const std::stop_token& stop);

}  // namespace floeplan::planning::refinement

#pragma once

#include <optional>

#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Checks whether the battery suffices for the plan. If not, the plan gets a message; if the request requires
/// the battery, the plan is refused instead. Both say where the battery would be empty, and how much energy
/// is missing.
/// Returns  the refusal; empty: none
[[nodiscard]] std::optional<Infeasible> check_battery(Plan& plan, const PlanRequest& request);

/// Checks whether the energy left at each waypoint suffices for the escape route from there. Result as
/// `check_battery`.
/// Precondition  the plan has its escape routes, one for each waypoint
[[nodiscard]] std::optional<Infeasible> check_escapes(Plan& plan, const PlanRequest& request);

}  // namespace floeplan::planning::publish

#pragma once

#include <optional>

#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Checks whether the battery carries the plan. If it does not, the plan gets a message; where the request insists on the
/// battery, the result is why there is no plan. Both say where the battery would be empty and how much is missing.
[[nodiscard]] std::optional<Infeasible> check_battery(Plan& plan, const PlanRequest& request);

/// Checks whether the energy left at each waypoint carries the escape route from there; the result is told likewise.
/// Precondition  the plan has its escapes, one for each waypoint
[[nodiscard]] std::optional<Infeasible> check_escapes(Plan& plan, const PlanRequest& request);

}  // namespace floeplan::planning::publish

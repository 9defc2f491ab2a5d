#pragma once

#include <optional>

#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Whether the battery carries the plan. If it does not: a message in the plan, or, where the request insists on
/// it, why there is no plan. Says where the battery would be empty and how much is missing.
[[nodiscard]] std::optional<Infeasible> check_battery(Plan& plan, const PlanRequest& request);

/// Whether what is left in the battery at each waypoint carries the escape from there; told in the same two ways.
/// Precondition  the plan has its escapes, one for each waypoint
[[nodiscard]] std::optional<Infeasible> check_escapes(Plan& plan, const PlanRequest& request);

}  // namespace floeplan::planning::publish

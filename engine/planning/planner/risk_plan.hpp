#pragma once

#include "engine/planning/planner/task.hpp"

namespace floeplan::planning::planner {

/// Plans with the request's weight on expected encounters with icebergs. The result is the plan without the weight, unless
/// another plan has fewer expected encounters and costs less with the weight. So the weight never increases the encounters.
/// `plan_unweighted` plans a request without the weight
/// Errors   as plan_route
/// Stops    as plan_route
[[nodiscard]] Result<Plan> plan_with_fewer_encounters(const Task& task, const Planning& plan_unweighted);

}  // namespace floeplan::planning::planner

#pragma once

#include "engine/planning/planner/task.hpp"

namespace floeplan::planning::planner {

/// Plans with the request's weight on expected encounters with icebergs: the plan without the weight, unless another
/// one expects fewer of them and costs less with it. So the weight never makes a plan expect more encounters.
/// `plan_unweighted` makes the plan without the weight, of the request without it.
/// Errors   as plan_route
/// Stops    as plan_route
[[nodiscard]] Result<Plan> plan_with_fewer_encounters(const Task& task, const Planning& plan_unweighted);

}  // namespace floeplan::planning::planner

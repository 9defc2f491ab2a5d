#pragma once

#include "engine/planning/planner/task.hpp"

namespace floeplan::planning::planner {

/// Plans the route with the earliest arrival in one sea, past the via points in the given order. It searches a smaller area,
/// and a larger one where that may give a better plan. Only the returned plan is compared with the best possible way.
/// Precondition  the request is valid
/// Errors and Stops  as plan_route
/// `rest`   is not used: there is no simpler plan
[[nodiscard]] Result<Plan> plan_fastest(const Task& task, const Planning& rest);

}  // namespace floeplan::planning::planner

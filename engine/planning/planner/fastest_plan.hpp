#pragma once

#include "engine/planning/planner/task.hpp"

namespace floeplan::planning::planner {

/// Plans the route that arrives earliest in one sea, past the vias in the order given: on the nearer grids, and on
/// the wider ones where they may do better. Only the plan that is given back is compared with the best possible way.
/// Precondition  the request is valid
/// Errors and Stops  as plan_route
/// `rest`   is not asked: there is nothing simpler
[[nodiscard]] Result<Plan> plan_fastest(const Task& task, const Planning& rest);

}  // namespace floeplan::planning::planner

#pragma once

#include "engine/planning/planner/task.hpp"
#include "engine/planning/problem/alternative.hpp"

namespace floeplan::planning::planner {

/// As `find_alternatives`. Calls `plan_once` for each obstacle; the calls run on the task's executor.
[[nodiscard]] Alternatives alternatives_to(const Plan& plan, const Task& task, const Planning& plan_once);

}  // namespace floeplan::planning::planner

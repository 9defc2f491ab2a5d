#pragma once

#include <span>
#include <stop_token>
#include <string_view>

#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/planner/task.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::planner {

/// A way to come to a plan by planning other, simpler tasks: one order of the vias, one of the members, the least time.
struct Strategy {
  std::string_view name;
  bool (*applies)(const Task&);
  /// `rest` plans a task by the strategies that come after this one.
  Result<Plan> (*plan)(const Task&, const Planning& rest);
};

/// In the order in which they are asked whether they apply. The last one always does.
[[nodiscard]] std::span<const Strategy> all_strategies();

/// Plans the task by the first strategy that applies.
/// Precondition  the request is valid
[[nodiscard]] Result<Plan> plan_by(std::span<const Strategy> strategies, const Task& task);

/// Does what `plan_route` does, without a diagnosis and on one kind of grid; for callers that plan many variants.
/// Errors and Stops  as `plan_route`
[[nodiscard]] Result<Plan> try_to_plan(const ocean::Environment& environment, const PlanRequest& request,
                                       const std::stop_token& stop, const core::ProgressCallback& progress,
                                       const core::Executor& executor = core::in_order());

}  // namespace floeplan::planning::planner

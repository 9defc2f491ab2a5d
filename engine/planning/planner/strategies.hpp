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

/// One kind of planning. It plans a task by planning simpler ones with `rest`: one order of the via points,
/// one member, or the earliest arrival.
struct Strategy {
  std::string_view name;
  bool (*applies)(const Task&);
  /// `rest` plans a task with the strategies after this one.
  Result<Plan> (*plan)(const Task&, const Planning& rest);
};

/// All strategies, in the order in which `applies` is called. The last one always applies.
[[nodiscard]] std::span<const Strategy> all_strategies();

/// Plans the task by the first strategy that applies.
/// Precondition  the request is valid
[[nodiscard]] Result<Plan> plan_by(std::span<const Strategy> strategies, const Task& task);

/// `plan_route` without diagnosis and on one kind of grid; for callers that plan many variants.
/// `known_route`: a route that the plan takes if its search finds no faster one; empty: none
/// Errors and Stops  as `plan_route`
[[nodiscard]] Result<Plan> try_to_plan(const ocean::Environment& environment, const PlanRequest& request,
                                       const std::stop_token& stop, const core::ProgressCallback& progress,
                                       const core::Executor& executor = core::in_order(),
                                       std::span<const geo::LonLat> known_route = {});

}  // namespace floeplan::planning::planner

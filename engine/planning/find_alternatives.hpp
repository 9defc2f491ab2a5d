#pragma once

#include <stop_token>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/alternative.hpp"
#include "engine/planning/problem/infeasible.hpp"

namespace floeplan::planning {

/// Finds up to `request.alternatives` routes that differ truly from a plan of `plan_route` and from each other: between any two
/// lies an island, a bank, a group of icebergs or a closed area of at least a twentieth of the distance from stop to stop.
/// Each is the plan of the same request with areas across the plan's route that are closed, so it can be planned again. None
/// takes more than twice the plan's time.
/// Area     that of `plan_route` without what it looks for in wider data
/// Limits   obstacles that the route passes nearest are tried, six at most; icebergs count where they are when the route
///          passes
/// Errors   std::invalid_argument when `request.violations()` is not empty; Infeasible only with Reason::cancelled
/// Stops    as `plan_route`
/// Threads  as `plan_route`. The result does not depend on the number of the executor's threads
[[nodiscard]] Result<Alternatives> find_alternatives(const ocean::Environment& environment,
                                                     const PlanRequest& request, const Plan& plan,
                                                     const std::stop_token& stop,
                                                     const core::ProgressCallback& progress,
                                                     const core::Executor& executor = core::in_order());

}  // namespace floeplan::planning

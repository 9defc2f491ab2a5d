#pragma once

#include <stop_token>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/wider_sea.hpp"

namespace floeplan::planning {

/// Plans the route of the request that is best by its objective, the fastest one unless it says otherwise, for its
/// departure; a window of departures and a wanted arrival are for `compare_departures` and `plan_arrival`.
/// Errors   std::invalid_argument when `request.violations()` is not empty; Infeasible when there is no such
///          route
/// Threads  may be called from several threads at once; reads its arguments only
/// Stops    within 100 ms of a request of `stop`, with Reason::cancelled. Every other bound counts work, so that the same
///          request in the same sea has the same plan on every machine
/// Area     ways are looked for within half the distance between stops beside the straight line, within the whole
///          of it where that leaves none or one along its rim, and where currents are as fast as the vehicle up to
///          250 km round, in what `wider` knows of that: as `best_of_more_grids`
[[nodiscard]] Result<Plan> plan_route(const ocean::Environment& environment, const PlanRequest& request,
                                      const std::stop_token& stop, const core::ProgressCallback& progress,
                                      const WiderSea& wider = {},
                                      const core::Executor& executor = core::in_order());

}  // namespace floeplan::planning

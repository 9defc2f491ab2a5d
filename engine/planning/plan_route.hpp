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

/// Plans the best route by the request's objective (the fastest unless it says otherwise) for the request's
/// departure. For a window of departures use `plan_window`, for a wanted arrival `plan_arrival`.
/// Errors   std::invalid_argument when `request.violations()` is not empty; Infeasible when there is no route
/// Threads  may be called from several threads at once; only reads its arguments
/// Stops    within 100 ms after `stop` is requested, with Reason::cancelled. Every other limit counts work,
///          so the same request with the same data gives the same plan on every machine
/// Area     Routes are searched up to half the distance between stops on each side of the straight line. If
///          there is none, or one along the rim, up to the whole distance. Where currents are as fast as the
///          vehicle, up to 250 km with the data that `wider` loads: see `best_of_more_grids`
[[nodiscard]] Result<Plan> plan_route(const ocean::Environment& environment, const PlanRequest& request,
                                      const std::stop_token& stop, const core::ProgressCallback& progress,
                                      const WiderSea& wider = {},
                                      const core::Executor& executor = core::in_order());

}  // namespace floeplan::planning

#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/window_plan.hpp"

namespace floeplan::planning::planner {

/// Finds, for each departure of the request's window, the earliest arrival, or the least cost if that is the
/// objective. Each result is that of a plan for this departure alone, without refinement. No departure is
/// skipped. The route of one departure bounds the search for the next, which saves time and changes no
/// result. Blocks of departures run on the executor and share the search areas and grids.
/// Returns  an outcome for each departure, in their order
/// Errors   only Reason::cancelled, within 100 ms after `stop` is requested
/// Throws   std::invalid_argument when `request.violations()` is not empty
[[nodiscard]] Result<std::vector<DepartureOutcome>> compare_departures(
    const ocean::Environment& environment, const PlanRequest& request, const std::stop_token& stop,
    const core::ProgressCallback& progress, const core::Executor& executor = core::in_order());

/// `plan_window` on the request's own grids alone, without a search for changes that would help.
[[nodiscard]] WindowPlan try_to_plan_window(const ocean::Environment& environment, const PlanRequest& request,
                                            const std::stop_token& stop,
                                            const core::ProgressCallback& progress,
                                            const core::Executor& executor = core::in_order());

/// The departure with the least cost by the objective, the first of equals. With a robust objective only
/// departures that are open in the most members count. Empty if all departures are closed.
[[nodiscard]] std::optional<std::size_t> best_departure(const std::vector<DepartureOutcome>& outcomes,
                                                        const Objective& objective = time_objective);

}  // namespace floeplan::planning::planner

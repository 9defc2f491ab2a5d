#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/clock.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/window_plan.hpp"

namespace floeplan::planning::planner {

/// Plans for each departure of the request's window, as for this departure alone but for the refinement: the earliest
/// arrival, or the least cost where the objective asks for it.
/// Exact for every departure: the curve has no gaps, so none is left out because it cannot win. The way of one
/// departure bounds the search for the next, which changes no result.
/// Returns  an outcome for each departure, in their order
/// Errors   Reason::cancelled alone, within 100 ms of a request of `stop`
/// Throws   std::invalid_argument when `request.violations()` is not empty
[[nodiscard]] Result<std::vector<DepartureOutcome>> compare_departures(
    const ocean::Environment& environment, const PlanRequest& request, const std::stop_token& stop,
    const core::ProgressCallback& progress);

/// As `plan_window`, on the request's own grids; an infeasible window is not told what would help.
[[nodiscard]] WindowPlan try_to_plan_window(const ocean::Environment& environment, const PlanRequest& request,
                                            const std::stop_token& stop,
                                            const core::ProgressCallback& progress,
                                            const core::SteadyClock& clock = {});

/// The departure that costs least by the objective, the first of equals; with a robust objective of those that most
/// members let through. Empty when every one is closed.
[[nodiscard]] std::optional<std::size_t> best_departure(const std::vector<DepartureOutcome>& outcomes,
                                                        const Objective& objective = time_objective);

}  // namespace floeplan::planning::planner

#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/clock.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/infeasible.hpp"
#include "engine/planning/open_grid.hpp"
#include "engine/planning/plan.hpp"
#include "engine/planning/plan_request.hpp"
#include "engine/planning/sea.hpp"
#include "engine/planning/strong_currents.hpp"

namespace floeplan::planning {

/// The latest departure from the first grid's start that is at the last grid's goal by `arrive`, on the grids'
/// legs: a search from the goal on the film run backwards. Exact under FIFO.
/// Returns  empty when there is none at or after `earliest`, or once `stop` is requested
[[nodiscard]] std::optional<core::Seconds> latest_departure(const Sea& sea,
                                                            const std::vector<OpenGrid>& grids,
                                                            core::Seconds arrive, core::Seconds earliest,
                                                            const std::stop_token& stop);

/// The same on one grid.
[[nodiscard]] std::optional<core::Seconds> latest_departure(const Sea& sea, const OpenGrid& open,
                                                            core::Seconds arrive, core::Seconds earliest,
                                                            const std::stop_token& stop);

/// The plan with the latest departure that arrives by the request's `departures.arrive_by`: the plan for this
/// departure alone. Its arrival is within a minute, or a thousandth of the travel time, of the wanted one unless
/// the sea lets none arrive then.
/// Errors   Reason::arrival_too_early when even the earliest departure, `request.depart`, arrives later; else
///          as plan_route
/// Throws   std::invalid_argument when `request.violations()` is not empty or no arrival is asked for
/// `clock` and `wider`: as plan_route's. More room is tried where no departure has a plan in time for currents as fast
/// as the vehicle.
[[nodiscard]] Result<Plan> plan_arrival(const ocean::Environment& environment, const PlanRequest& request,
                                        const std::stop_token& stop, const core::ProgressCallback& progress,
                                        const core::SteadyClock& clock = {}, const WiderSea& wider = {});

}  // namespace floeplan::planning

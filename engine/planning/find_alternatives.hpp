#pragma once

#include <stop_token>

#include "engine/core/executor.hpp"
#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/alternative.hpp"
#include "engine/planning/problem/infeasible.hpp"

namespace floeplan::planning {

/// Finds up to `request.alternatives` routes that really differ from a plan of `plan_route` and from each
/// other: between any two lies an obstacle of at least a twentieth of the distance from stop to stop, such as
/// an island, a bank, a group of icebergs or a closed area. Each alternative is the plan of the same request
/// with closed areas across the plan's route, so it can be planned again. None takes more than twice the
/// plan's time. A route that turns out to cost less than the plan takes its place (`Alternatives::better`): closed areas
/// only take routes away, so it is a plan of the request, too.
/// Area     that of `plan_route`, without the wider data
/// Limits   at most six obstacles are tried, those nearest to the route first; icebergs count where they are
///          when the route passes
/// Errors   std::invalid_argument when `request.violations()` is not empty; Infeasible only with
///          Reason::cancelled
/// Stops    as `plan_route`
/// Threads  as `plan_route`. The result does not depend on the number of the executor's threads
[[nodiscard]] Result<Alternatives> find_alternatives(const ocean::Environment& environment,
                                                     const PlanRequest& request, const Plan& plan,
                                                     const std::stop_token& stop,
                                                     const core::ProgressCallback& progress,
                                                     const core::Executor& executor = core::in_order());

}  // namespace floeplan::planning

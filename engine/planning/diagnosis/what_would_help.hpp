#pragma once

#include <stop_token>

#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// Adds to `why` changes of single inputs that make a plan possible. Each change has been tested. With a
/// wanted arrival a trial departs at `request.depart` and must arrive in time.
/// If no value of any input helps, trials leave out the icebergs, the zones, the ice and the currents, one
/// kind at a time. The first kind without which a route exists becomes the binding constraint.
/// For a refusal due to missing data the result also names the data that end.
/// Nothing is added if a plan at the request's departure, with via points in the given order, is possible.
/// `why`    why the request has no plan; its changes are kept. Its explanation is reported as a stage of
/// progress first
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Infeasible with_what_would_help(const ocean::Environment& environment,
                                              const PlanRequest& request, Infeasible why,
                                              const std::stop_token& stop,
                                              const core::ProgressCallback& progress);

}  // namespace floeplan::planning::diagnosis

#pragma once

#include <stop_token>

#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// `why`, with changes of single inputs that make a plan possible. Each change has been tried. With a wanted arrival a
/// trial leaves at the request's departure and must arrive in time.
/// Where no value of any input helps, the sea is tried without its icebergs, without its zones, without its ice and
/// without its currents. The first of these without which there is a route becomes the binding constraint.
/// A refusal for want of data names the data that end, too.
/// There are no changes where one plan at the request's departure, in the given order of via points, is possible.
/// `why`    why the request has no plan; changes that it has already are kept. Its explanation is told as the stage of
///          the work before anything is tried
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Infeasible with_what_would_help(const ocean::Environment& environment,
                                              const PlanRequest& request, Infeasible why,
                                              const std::stop_token& stop,
                                              const core::ProgressCallback& progress);

}  // namespace floeplan::planning::diagnosis

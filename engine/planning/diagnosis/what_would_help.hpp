#pragma once

#include <stop_token>

#include "engine/core/progress.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// Why the request is not possible, with the single changes that would make it so, each of them tried: where an arrival
/// is wanted, to leave at its departure and be there by then.
/// Where no input governs what stopped the search, or no value of any helps, the sea is tried without its icebergs,
/// zones, ice or currents, one after the other: the first without which there is a way binds instead, with its changes.
/// None where a single plan, at the request's departure and in the order given, is possible as it is.
/// `why`    its changes are kept where it names some already
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Infeasible with_what_would_help(const ocean::Environment& environment,
                                              const PlanRequest& request, Infeasible why,
                                              const std::stop_token& stop,
                                              const core::ProgressCallback& progress);

}  // namespace floeplan::planning::diagnosis

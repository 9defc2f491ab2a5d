#pragma once

#include <stop_token>
#include <string>

#include "engine/ocean/environment.hpp"
#include "engine/planning/diagnosis/input_changes.hpp"
#include "engine/planning/diagnosis/input_trials.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// The start, the goal or a via point of a request, by its name in the inputs: "from", "to", "via/0".
[[nodiscard]] geo::LonLat& stop_named(PlanRequest& request, const std::string& input);

/// Changes that make a request possible; each changes one input. For each input that can help against the binding
/// constraint, the smallest change is found by bisection between the value of the request and the most generous
/// value. If a more generous value need not help more, the values are tried one after the other.
/// `why`    the reason without a plan, with the binding constraint. If the water reopens later, a later departure,
///          a hold and another goal are tried first. `why.changes` are moves of a stop that have been found to help
/// `without_stored_zones`  a trial in the same water without the stored zones; empty: not tried
/// Accuracy a hundredth of the interval; only changes with a successful trial are returned. A trial without an answer
/// counts as failed, and the result says so
/// Bounds   at most 90 trials; none for constraints that no input governs (land, memory)
/// Stops    once `stop` is requested, and returns what it has found so far
[[nodiscard]] FoundChanges find_changes(const ocean::Environment& environment, const PlanRequest& request,
                                        const Infeasible& why, const Trial& trial,
                                        const std::stop_token& stop, const Trial& without_stored_zones = {});

}  // namespace floeplan::planning::diagnosis

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

/// Changes of one input each that make a request possible. For each input that can help against the binding
/// constraint the smallest change is found: by bisection between the request's value and the most generous one, or by
/// trying value after value where a more generous value need not help more.
/// `why`    why the request has no plan, with the binding constraint. If that reopens later, a later departure, a
///          hold and another goal are tried first. Its changes are moves of a stop that have been found to help
/// `without_stored_zones`  a trial without the stored zones, in the same waters; empty: not tried
/// Accuracy a hundredth of the interval; only changes with a successful trial are returned. A trial without an answer
/// counts as failed, and the result says so
/// Bounds   at most 90 trials; none for constraints that no input governs (land, memory)
/// Stops    once `stop` is requested, and returns what it has found so far
[[nodiscard]] FoundChanges find_changes(const ocean::Environment& environment, const PlanRequest& request,
                                        const Infeasible& why, const Trial& trial,
                                        const std::stop_token& stop, const Trial& without_stored_zones = {});

}  // namespace floeplan::planning::diagnosis

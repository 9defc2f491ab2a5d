#pragma once

#include <stop_token>
#include <string>

#include "engine/ocean/environment.hpp"
#include "engine/planning/diagnosis/input_changes.hpp"
#include "engine/planning/diagnosis/input_trials.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// The start, the goal or a place on the way by its name in the inputs: "from", "to", "via/0".
[[nodiscard]] geo::LonLat& stop_named(PlanRequest& request, const std::string& input);

/// Single changes of a request's inputs that make it possible: for each input that can help against the binding
/// constraint the smallest one found, by halving an interval between the request's value and the most generous one,
/// or by trying one after the other where less is not always easier.
/// `why`    the request is not possible: what binds; where that opens again, leaving later, waiting and another goal
///          are tried first. Its changes are moves of a stop that helped already
/// `without_stored_zones`  tells of the request in the same sea without the environment's zones; empty: not tried
/// Accuracy a hundredth of the interval; a change is only named when its trial succeeded. A trial that tells nothing
///          counts as one that failed, and the result says so
/// Bounds   at most 90 trials; none for constraints that no input governs (land, memory)
/// Stops    with what was found so far once `stop` is requested
[[nodiscard]] FoundChanges find_changes(const ocean::Environment& environment, const PlanRequest& request,
                                        const Infeasible& why, const Trial& trial,
                                        const std::stop_token& stop, const Trial& without_stored_zones = {});

}  // namespace floeplan::planning::diagnosis

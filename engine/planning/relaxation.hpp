#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/infeasible.hpp"
#include "engine/planning/plan_request.hpp"

namespace floeplan::planning {

/// Whether there is a way for another request in the same sea.
using Trial = std::function<bool(const PlanRequest&)>;

/// Single changes of a request's inputs that make it possible: for each input that can help against the binding
/// constraint the smallest one found, by halving an interval between the request's value and the most generous one,
/// or by trying one after the other where less is not always easier. The one that asks least comes first.
/// Accuracy a twentieth of the interval; a change is only named when its trial succeeded
/// Bounds   at most 30 trials; none for constraints that no input governs (land, memory)
/// Stops    with what was found so far once `stop` is requested
[[nodiscard]] std::vector<Change> find_changes(const ocean::Environment& environment,
                                               const PlanRequest& request, Constraint binding,
                                               const Trial& trial, const std::stop_token& stop);

}  // namespace floeplan::planning

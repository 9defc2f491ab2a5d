#pragma once

#include <optional>
#include <stop_token>

#include "engine/ocean/environment.hpp"
#include "engine/planning/diagnosis/input_trials.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// A change that makes a request possible only together with another one (its `with`). It helps where two constraints
/// close the route: the binding one, and one more of areas, depths, icebergs, ice, currents and the battery. The inputs
/// against the second constraint first get their most generous values. After a change against the binding constraint is
/// found, they are changed only as far as is needed.
/// `why`    why the request has no plan; `find_changes` found no single change for it
/// Law      a trial of the request with both changes has succeeded
/// Stops    and returns nothing once `stop` is requested
[[nodiscard]] std::optional<Change> change_with_another(const ocean::Environment& environment,
                                                        const PlanRequest& request, const Infeasible& why,
                                                        const Trial& trial, const std::stop_token& stop);

}  // namespace floeplan::planning::diagnosis

#pragma once

#include <optional>
#include <stop_token>

#include "engine/ocean/environment.hpp"
#include "engine/planning/diagnosis/input_trials.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::diagnosis {

/// A change that makes a request possible together with another (`with`), where two things stand in the way one behind
/// the other: against what binds, and against one more of areas, depths, icebergs, ice, currents and the battery. The
/// inputs against the latter are first changed as far as they go, then, beside the first change, only as far as is
/// needed.
/// `why`    as of `find_changes`, which found nothing against what binds
/// Law      a trial of the request with both changes has succeeded
/// Stops    with nothing once `stop` is requested
[[nodiscard]] std::optional<Change> change_with_another(const ocean::Environment& environment,
                                                        const PlanRequest& request, const Infeasible& why,
                                                        const Trial& trial, const std::stop_token& stop);

}  // namespace floeplan::planning::diagnosis

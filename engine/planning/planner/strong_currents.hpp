#pragma once

#include <optional>
#include <stop_token>

#include "engine/ocean/environment.hpp"
#include "engine/planning/planner/task.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/wider_sea.hpp"

namespace floeplan::planning::planner {

/// Whether anywhere and at any time a current is as fast as the vehicle: weaker ones close no leg, though they may make
/// a way too long for what else is asked of it. False once `stop` is requested.
[[nodiscard]] bool any_current_may_close(const ocean::CurrentGrid& currents, const PlanRequest& request,
                                         const std::stop_token& stop);

/// A request with more room than usual, and the sea to plan it in.
struct Roomy {
  PlanRequest request;
  ocean::Environment sea;
};

/// Several times as far as the stops are from each other, but no further than eddies are wide that carry a vehicle
/// round; less where the currents of such an area would be too many samples.
/// Returns  empty where that is no more than usual, or nothing is known of it
/// `wider`  empty: the environment holds all that there is
[[nodiscard]] std::optional<Roomy> with_more_room(const ocean::Environment& environment,
                                                  const PlanRequest& request, const WiderSea& wider);

/// Whether what refused the request may be a current as fast as the vehicle, round which a way may lead that takes more
/// room than ways were looked for in.
[[nodiscard]] bool more_room_may_help(const Infeasible& why, const ocean::Environment& environment,
                                      const PlanRequest& request, const std::stop_token& stop);

/// Says of such a refusal how far ways were looked for.
/// `looked_for`  the request with the most room that was tried
[[nodiscard]] Infeasible with_area_searched(Infeasible why, const PlanRequest& looked_for);

/// The share of the work that a plan on the usual grids is expected to be: half of it where currents may call for more
/// grids, else all.
[[nodiscard]] double share_of_usual_grids(const ocean::Environment& environment, const PlanRequest& request,
                                          const std::stop_token& stop);

/// Where currents are as fast as the vehicle whole legs are closed, so that ways that one grid has are missing on
/// another, and the way may lead far round: the best of the plan that is known and of those with more directions, with
/// more room and on coarser grids. Anywhere else the plan that is known.
/// Work     a few times that of the known plan; nothing else is tried where that one was much work already, where the
///          time without surfacing is bounded and where the currents are uncertain
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> best_of_more_grids(Result<Plan> known, const Task& task,
                                              const Planning& plan_once);

}  // namespace floeplan::planning::planner

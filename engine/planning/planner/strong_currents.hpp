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

/// Whether anywhere and at any time a current is as fast as the vehicle. Weaker currents close no leg, but
/// may make a route too long for the time without surfacing or the energy. False once `stop` is requested.
[[nodiscard]] bool any_current_may_close(const ocean::CurrentGrid& currents, const PlanRequest& request,
                                         const std::stop_token& stop);

/// A request with more room than usual, and the environment for it.
struct Roomy {
  PlanRequest request;
  ocean::Environment sea;
};

/// A request with room for routes round the eddies that carry a vehicle: several times the distance between
/// stops, at most 250 km. Less if the currents of that area would be too many samples.
/// Returns  empty if this is no more room than usual, or no currents are known there
/// `wider`  loads data of a larger area; empty: the environment holds all data
[[nodiscard]] std::optional<Roomy> with_more_room(const ocean::Environment& environment,
                                                  const PlanRequest& request, const WiderSea& wider);

/// Whether the refusal may be due to a current as fast as the vehicle, and a route round it may need more
/// room than the searched area had.
[[nodiscard]] bool more_room_may_help(const Infeasible& why, const ocean::Environment& environment,
                                      const PlanRequest& request, const std::stop_token& stop);

/// Adds to such a refusal how large the searched area was.
/// `looked_for`  the request with the most room that was tried
[[nodiscard]] Infeasible with_area_searched(Infeasible why, const PlanRequest& looked_for);

/// Expected share of the work for the plan on the usual grids: a half if strong currents may call for more
/// grids, otherwise all.
[[nodiscard]] double share_of_usual_grids(const ocean::Environment& environment, const PlanRequest& request,
                                          const std::stop_token& stop);

/// The best of the known plan and, if currents are as fast as the vehicle, of plans with more directions,
/// with more room and on coarser grids. Such currents close whole legs, so one grid may miss a route that
/// another has, and the route may lead far round. Without such currents returns the known plan.
/// Work     a few times that of the known plan. Nothing else is tried if that plan took much work, if the
///          time without surfacing is limited, or if the currents are uncertain
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> best_of_more_grids(Result<Plan> known, const Task& task,
                                              const Planning& plan_once);

}  // namespace floeplan::planning::planner

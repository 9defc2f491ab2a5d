#pragma once

#include <stop_token>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/planner/task.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/chart.hpp"

namespace floeplan::planning::planner {

/// Plans the route with the least cost by the request's objective. Each leg uses the propulsion with the
/// least cost. The fastest plans with each propulsion are made, too, so the plan never costs more than they
/// do.
/// Precondition  the request is valid
/// Errors and Stops  as plan_route
[[nodiscard]] Result<Plan> plan_least_cost(const Task& task, const Planning& plan_fastest);

/// The cost of a plan by the objective. Precondition: `plan.energy` is not empty.
[[nodiscard]] double cost_of(const Plan& plan, const Objective& objective);

/// The request for the fastest plan with one propulsion.
[[nodiscard]] PlanRequest fastest_request(const PlanRequest& request, vehicle::Drive drive);

/// The plans that are known before a search for the least cost.
struct KnownPlan {
  Result<Plan> plan;                      // the cheapest known plan
  std::vector<vehicle::Drive> on_drives;  // a plan exists that uses only this propulsion
};

/// The best of the known plan and of searches for the least cost without holds, with all kinds of propulsion
/// and, if that search is cut short, with each of `on_drives` alone. The searches use coarser grids. The request's own grids follow if the
/// coarse result costs too much to be taken, or if the request fixes the grid.
[[nodiscard]] Result<Plan> search_least_cost_plan(const KnownPlan& known, const Task& task);

/// The plan straight from stop to stop, with the propulsion of least total cost; without holds.
/// Errors   the route is closed, the energy does not suffice, or there is no escape route; Reason::cancelled
///          once `stop` is requested
[[nodiscard]] Result<Plan> publish_straight_way(const search::Chart& chart,
                                                const ocean::Environment& environment,
                                                const PlanRequest& request, const std::stop_token& stop);

}  // namespace floeplan::planning::planner

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

/// Plans the route with the least cost by the request's objective. Each leg takes the drive with the least cost. The plan never
/// costs more than the fastest plans on either drive, which are made and compared, too.
/// Precondition  the request is valid
/// Errors and Stops  as plan_route
[[nodiscard]] Result<Plan> plan_least_cost(const Task& task, const Planning& plan_fastest);

/// The cost of a plan by the objective. Precondition: the plan has its energy, as every plan of this version does.
[[nodiscard]] double cost_of(const Plan& plan, const Objective& objective);

/// The request for the fastest plan on one drive.
[[nodiscard]] PlanRequest fastest_request(const PlanRequest& request, vehicle::Drive drive);

/// The plans that are known before a search for the least cost.
struct KnownPlan {
  Result<Plan> plan;                      // the cheapest so far
  std::vector<vehicle::Drive> on_drives;  // drives for which there is a plan with all legs on that drive
};

/// The best of the known plan and of searches without holds, with all drives and with each of the known drives alone. They run
/// on coarser grids; where these give no evidence, or the request fixes the grid, on the request's own.
[[nodiscard]] Result<Plan> search_least_cost_plan(const KnownPlan& known, const Task& task);

/// The plan straight from stop to stop, on the drives with the least total cost; without holds.
/// Errors   why the way is closed, the battery does not carry the vehicle where it must, or there is no escape;
///          Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> publish_straight_way(const search::Chart& chart,
                                                const ocean::Environment& environment,
                                                const PlanRequest& request, const std::stop_token& stop);

}  // namespace floeplan::planning::planner

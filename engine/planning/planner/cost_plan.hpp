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

/// Plans the route that costs least by the request's objective, leg by leg on the drive that suits it. Never
/// costs more than the fastest plans on either drive: they are made, too, and compared.
/// Precondition  the request is valid
/// Errors and Stops  as plan_route
[[nodiscard]] Result<Plan> plan_least_cost(const Task& task, const Planning& plan_fastest);

/// What a plan costs by the objective. Precondition: it tells its energy, as every plan of this version does.
[[nodiscard]] double cost_of(const Plan& plan, const Objective& objective);

/// The request for the fastest plan on one drive.
[[nodiscard]] PlanRequest fastest_request(const PlanRequest& request, vehicle::Drive drive);

/// What is known before a search for the least cost.
struct KnownPlan {
  Result<Plan> plan;                      // the cheapest so far
  std::vector<vehicle::Drive> on_drives;  // that have a plan each, all legs on that drive
};

/// The better of the known plan and what searches find without waits, for all drives and for each of the known ones by
/// itself: on coarser grids; where those are no evidence, and where the request leaves no choice, on the request's own.
[[nodiscard]] Result<Plan> search_least_cost_plan(const KnownPlan& known, const Task& task);

/// The plan straight from stop to stop of the request, on the drives that make the whole cost least; without waits.
/// Errors   why the way is closed, the battery does not carry the vehicle where it must, or there is no escape;
///          Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> publish_straight_way(const search::Chart& chart,
                                                const ocean::Environment& environment,
                                                const PlanRequest& request, const std::stop_token& stop);

}  // namespace floeplan::planning::planner

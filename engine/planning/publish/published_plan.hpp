#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/publish/improvement.hpp"
#include "engine/planning/search/chart.hpp"

namespace floeplan::planning::publish {

/// The plan of a route with the first propulsion of the model. The route is timed once more by the leg cost
/// model, as for every plan. Only the comparison with the best possible route (`rate`) is missing.
/// Errors   why the route is closed, why the battery does not suffice although it must, or from where there
///          is no escape route; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> publish(const search::Chart& chart, const ocean::Environment& environment,
                                   const PlanRequest& request, const Improved& improved,
                                   const SearchStatistics& statistics, const std::stop_token& stop);

/// Adds messages about the search and the refinement.
void add_messages(Plan& plan, const PlanRequest& request);

/// Adds the escape routes, if the request asks for them. `points` are the plan's waypoints in the plane,
/// `arrivals` the times there, `drives` the propulsion of its legs.
/// Returns  why there are none, or that the battery does not suffice for one; empty: no problem
[[nodiscard]] std::optional<Infeasible> add_escapes(Plan& plan, const search::Chart& chart,
                                                    const PlanRequest& request,
                                                    const std::vector<geo::PlanePoint>& points,
                                                    const std::vector<core::Seconds>& arrivals,
                                                    const std::vector<vehicle::Drive>& drives,
                                                    const std::stop_token& stop);

/// Adds the optimality gap of the plan, or the reason why there is none, if the request asks for it.
void rate(Plan& plan, const cost::Sea& sea, const PlanRequest& request, const cost::Route& route,
          const std::stop_token& stop);

}  // namespace floeplan::planning::publish

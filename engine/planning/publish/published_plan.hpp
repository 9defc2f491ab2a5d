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

/// The plan of a route on the sea's first drive, timed once more by the one cost. It is complete but for the comparison
/// with the best possible route.
/// Errors   why the route is closed, why the battery does not carry it where it must, or from where there is no escape
///          route; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> publish(const search::Chart& chart, const ocean::Environment& environment,
                                   const PlanRequest& request, const Improved& improved,
                                   const SearchStatistics& statistics, const std::stop_token& stop);

/// Adds the messages of the search and the refinement of a plan.
void add_messages(Plan& plan, const PlanRequest& request);

/// Adds the escape routes, if the request asks for them. `arrivals` are those at the `points` of the plan's waypoints,
/// `drives` those of its legs.
/// Returns  why there are none, or that the battery does not carry the vehicle along one; empty: all is well
[[nodiscard]] std::optional<Infeasible> add_escapes(Plan& plan, const search::Chart& chart,
                                                    const PlanRequest& request,
                                                    const std::vector<geo::PlanePoint>& points,
                                                    const std::vector<core::Seconds>& arrivals,
                                                    const std::vector<vehicle::Drive>& drives,
                                                    const std::stop_token& stop);

/// Adds how near to the best possible the route is, if the request asks for it.
void rate(Plan& plan, const cost::Sea& sea, const PlanRequest& request, const cost::Route& route,
          const std::stop_token& stop);

}  // namespace floeplan::planning::publish

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

/// The plan of a route on the sea's first drive, timed once more by the one cost, with all that is told of it but how
/// near the best it is.
/// Errors   why the route is closed, the battery does not carry it where it must, or there is no escape from it;
///          Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> publish(const search::Chart& chart, const ocean::Environment& environment,
                                   const PlanRequest& request, const Improved& improved,
                                   const SearchStatistics& statistics, const std::stop_token& stop);

/// What the search and the refinement of the plan say for themselves.
void add_messages(Plan& plan, const PlanRequest& request);

/// Adds the ways to where the vehicle may surface, where they were asked for; `arrivals` are those at the `points` of
/// the plan's waypoints, `drives` those of its legs. Answers why there are none, or that the battery does not carry the
/// vehicle along one; empty: all is well.
[[nodiscard]] std::optional<Infeasible> add_escapes(Plan& plan, const search::Chart& chart,
                                                    const PlanRequest& request,
                                                    const std::vector<geo::PlanePoint>& points,
                                                    const std::vector<core::Seconds>& arrivals,
                                                    const std::vector<vehicle::Drive>& drives,
                                                    const std::stop_token& stop);

/// Tells of the plan how near the best possible its route is, where that was asked for.
void rate(Plan& plan, const cost::Sea& sea, const PlanRequest& request, const cost::Route& route,
          const std::stop_token& stop);

}  // namespace floeplan::planning::publish

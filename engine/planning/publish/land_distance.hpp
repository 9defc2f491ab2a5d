#pragma once

#include <optional>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/schedule.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Least distance from the route to the lines of the coast. Empty without a coastline.
[[nodiscard]] std::optional<core::Metres> land_clearance(const cost::Sea& sea,
                                                         const ocean::Environment& environment,
                                                         const std::vector<geo::PlanePoint>& route);

/// Warns of the place where the route passes nearest to land among those that are closer to it than the position error.
/// Rule    the error grows as grown_error says, from zero at the start, for one dive to the planned depth or
///         for the requested time between surfacings; if the plan states a larger error at the end of the
///         leg, the larger one counts
/// `plan`  with its waypoints and surfacings
[[nodiscard]] std::optional<messages::Message> land_warning(const Plan& plan, const cost::Sea& sea,
                                                            const ocean::Environment& environment,
                                                            const PlanRequest& request,
                                                            const std::vector<geo::PlanePoint>& route,
                                                            const cost::Schedule& schedule);

}  // namespace floeplan::planning::publish

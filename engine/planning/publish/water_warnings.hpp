#pragma once

#include <vector>

#include "engine/messages/message.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Warnings about the currents of a route: where they are those of the nearest water, where dives go below the known
/// currents, and where the vehicle needs nearly all its speed to hold the course.
/// `drives` one for each leg
[[nodiscard]] std::vector<messages::Message> water_warnings(const cost::Sea& sea,
                                                            const ocean::Environment& environment,
                                                            const PlanRequest& request,
                                                            const std::vector<geo::PlanePoint>& route,
                                                            const cost::Schedule& schedule,
                                                            const std::vector<vehicle::Drive>& drives);

}  // namespace floeplan::planning::publish

#pragma once

#include <vector>

#include "engine/messages/message.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// What a pilot has to know of the currents that a route rests on: where they are those of other water, where dives go
/// deeper than they are known, and where they leave the vehicle hardly any speed to hold its course with.
/// `drives` one for each leg
[[nodiscard]] std::vector<messages::Message> water_warnings(const cost::Sea& sea,
                                                            const ocean::Environment& environment,
                                                            const PlanRequest& request,
                                                            const std::vector<geo::PlanePoint>& route,
                                                            const cost::Schedule& schedule,
                                                            const std::vector<vehicle::Drive>& drives);

}  // namespace floeplan::planning::publish

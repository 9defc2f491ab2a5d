#pragma once

#include <optional>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Warns where a route passes an area so soon after it opens, or so shortly before it closes, that a vehicle somewhat faster
/// or slower than planned would break its rule. Names the place with the least time to spare; empty: there is none.
/// `drives` one for each leg
[[nodiscard]] std::optional<messages::Message> zone_warning(const cost::Sea& sea, const PlanRequest& request,
                                                            const std::vector<geo::PlanePoint>& route,
                                                            const cost::Schedule& schedule,
                                                            const std::vector<vehicle::Drive>& drives);

}  // namespace floeplan::planning::publish

#pragma once

#include <stop_token>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::publish {

/// Tells of icebergs that drift for a time without known currents: a caution names those that may come near the route, a
/// note counts the others.
/// Near     the iceberg is taken to move straight towards the vehicle as far as it drifts at most, with a known current, in
///          as long a time as the current is unknown. It is near if the vehicle then enters its keep-out distance. Where the
///          current is unknown for most of the time, the iceberg is taken to be as fast as the others on the average: a few
///          hours, of one phase of the tide, tell little. If no current is ever known, all icebergs count as near
/// `drives` one for each leg
/// Stops    early, with messages that must not be used, once `stop` is requested
[[nodiscard]] std::vector<messages::Message> drift_warnings(
    const cost::Sea& sea, const ocean::Environment& environment, const PlanRequest& request,
    const std::vector<geo::PlanePoint>& route, const cost::Schedule& schedule,
    const std::vector<vehicle::Drive>& drives, const std::stop_token& stop);

/// The environment's messages without those that speak of the drift of all its icebergs, near the route or not.
[[nodiscard]] std::vector<messages::Message> messages_beside_drift(const ocean::Environment& environment);

}  // namespace floeplan::planning::publish

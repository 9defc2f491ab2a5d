#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/plan.hpp"
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

/// Warns where a route passes an area so soon after it opens, or so shortly before it closes, that a vehicle somewhat faster
/// or slower than planned would break its rule. Names the place with the least time to spare; empty: there is none.
/// `drives` one for each leg
[[nodiscard]] std::optional<messages::Message> zone_warning(const cost::Sea& sea, const PlanRequest& request,
                                                            const std::vector<geo::PlanePoint>& route,
                                                            const cost::Schedule& schedule,
                                                            const std::vector<vehicle::Drive>& drives);

/// Adds messages about ice above the route. Dangers: a start, a goal or a via point under ice, and more than 12 h below ice
/// without a place to surface. Caution: a start or a goal whose ice is not known. There is no message about the time where
/// the pilot bounds the time without surfacing.
/// Rule     a place is under ice where the vehicle may not surface and its dives turn below keels, as in the simulator
/// Precondition  the plan tells of its surfacings, one state for each waypoint
void tell_of_ice_above(Plan& plan, const PlanRequest& request);

}  // namespace floeplan::planning::publish

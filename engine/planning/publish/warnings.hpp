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

/// Warnings about the currents of a route: where they are taken from the nearest water, where dives go below
/// the known currents, and where the vehicle needs nearly all its speed to hold the course.
/// `drives` one for each leg
[[nodiscard]] std::vector<messages::Message> water_warnings(const cost::Sea& sea,
                                                            const ocean::Environment& environment,
                                                            const PlanRequest& request,
                                                            const std::vector<geo::PlanePoint>& route,
                                                            const cost::Schedule& schedule,
                                                            const std::vector<vehicle::Drive>& drives);

/// Messages about icebergs that drift for a time without known currents. A caution names those that may come
/// near the route; a note counts the others.
/// Near     The iceberg is assumed to move straight towards the vehicle while its current is unknown. Its
///          distance is the largest that it covers in an equally long period with known currents. It is near
///          if the vehicle then enters its keep-out distance. If the current is unknown most of the time, the
///          mean speed of the other icebergs is used: a few hours, in one phase of the tide, tell little. If
///          no current is ever known, all icebergs count as near
/// `drives` one for each leg
/// Stops    early, with messages that must not be used, once `stop` is requested
[[nodiscard]] std::vector<messages::Message> drift_warnings(
    const cost::Sea& sea, const ocean::Environment& environment, const PlanRequest& request,
    const std::vector<geo::PlanePoint>& route, const cost::Schedule& schedule,
    const std::vector<vehicle::Drive>& drives, const std::stop_token& stop);

/// The environment's messages, except those about the drift of all its icebergs: `drift_warnings` replaces
/// them.
[[nodiscard]] std::vector<messages::Message> messages_beside_drift(const ocean::Environment& environment);

/// Warns if a route passes an area so soon after it opens, or so shortly before it closes, that a vehicle
/// slightly faster or slower than planned would break the area's rule. Names the place with the least spare
/// time; empty: no such place.
/// `drives` one for each leg
[[nodiscard]] std::optional<messages::Message> zone_warning(const cost::Sea& sea, const PlanRequest& request,
                                                            const std::vector<geo::PlanePoint>& route,
                                                            const cost::Schedule& schedule,
                                                            const std::vector<vehicle::Drive>& drives);

/// Adds messages about ice above the route. Dangers: a start, goal or via point under ice, and more than 12 h
/// below ice without a place to surface. Caution: a start or goal whose ice is unknown. The message about the
/// time is left out if the pilot limits the time without surfacing.
/// Rule     a place is under ice if the vehicle may not surface and its dives turn below keels, as in the
///          simulator
/// Precondition  the plan has its surfacings, with one state for each waypoint
void tell_of_ice_above(Plan& plan, const PlanRequest& request);

}  // namespace floeplan::planning::publish

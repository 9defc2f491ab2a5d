#pragma once

#include <optional>

#include "engine/ocean/environment.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/grid/search_outcome.hpp"

namespace floeplan::planning::search {

/// The role of a place in a route.
enum class Stop { start, via, goal };

/// Says why a start, goal or via point cannot be used. outside_data: the bathymetry has no depth there.
[[nodiscard]] Infeasible explain_place(motion::EdgeClosed closed, Stop stop, geo::LonLat place,
                                       const cost::Sea& sea, const ocean::Environment& environment,
                                       const PlanRequest& request);

/// Says how far from a start, goal or via point on land or in shallow water the nearest water is that the vehicle can use.
/// `nearest`: of nearest_usable_place.
[[nodiscard]] messages::Message tell_of_nearest_water(Stop stop, geo::LonLat place,
                                                      const std::optional<geo::LonLat>& nearest);

/// Says what closes the start at the departure for so long, and when it reopens.
[[nodiscard]] Infeasible explain_start(motion::EdgeClosed closed, geo::LonLat place, core::Seconds after,
                                       const cost::Sea& sea, const PlanRequest& request);

/// Says why a given route, or the straight line, cannot be travelled.
[[nodiscard]] Infeasible explain_route(const cost::RouteClosed& closed, const cost::Sea& sea,
                                       const PlanRequest& request);

/// Says where a search for `stop` ended, and why. If the vehicle could arrive there, the cause is what closes
/// the stop itself; otherwise it is what closes most edges out of the nearest reached vertex.
[[nodiscard]] Infeasible explain_search(const RouteSearch& search, Stop kind, geo::PlanePoint stop,
                                        const cost::Sea& sea, const PlanRequest& request);

/// Replaces the cause in `why` by a sharper one: without this constraint (all icebergs, all zones, the ice or
/// the currents) there would be a route.
[[nodiscard]] Infeasible explain_removable(Infeasible why, Constraint constraint);

/// Says from which point of a route no escape route exists.
[[nodiscard]] Infeasible explain_no_escape(const cost::Sea& sea, const PlanRequest& request,
                                           geo::PlanePoint place, core::Seconds when);

[[nodiscard]] Infeasible explain_cancelled(const PlanRequest& request);

/// The change that moves a stop to another place. `input` names the stop as the inputs do: "from", "to" or "via/0".
[[nodiscard]] Change move_of(const std::string& input, geo::LonLat from, geo::LonLat to);
[[nodiscard]] Infeasible explain_too_large(double vertices, const PlanRequest& request);
[[nodiscard]] Infeasible explain_too_many_icebergs(std::size_t icebergs, const PlanRequest& request);

}  // namespace floeplan::planning::search

#pragma once

#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/grid/search_outcome.hpp"

namespace floeplan::planning::search {

/// What a place is to a route.
enum class Stop { start, via, goal };

/// Says why a start, goal or via cannot be used.
[[nodiscard]] Infeasible explain_place(motion::EdgeClosed closed, Stop stop, geo::LonLat place,
                                       const cost::Sea& sea, const PlanRequest& request);

/// Says what keeps the vehicle from its start so long after the request's departure, and until when.
[[nodiscard]] Infeasible explain_start(motion::EdgeClosed closed, geo::LonLat place, core::Seconds after,
                                       const cost::Sea& sea, const PlanRequest& request);

/// Says why a given route, or the straight line, cannot be travelled.
[[nodiscard]] Infeasible explain_route(const cost::RouteClosed& closed, const cost::Sea& sea,
                                       const PlanRequest& request);

/// Says where a search for `stop`, of its kind, stopped and what stood in its way: what is over the stop itself when the
/// vehicle could be there, or else what closes most of the ways onward from the place nearest to it.
[[nodiscard]] Infeasible explain_search(const RouteSearch& search, Stop kind, geo::PlanePoint stop,
                                        const cost::Sea& sea, const PlanRequest& request);

/// Says of a search that there would be a way without all icebergs, all zones, the ice or the currents, whatever closed
/// most of the ways where the search ended.
[[nodiscard]] Infeasible explain_removable(Infeasible why, Constraint constraint);

/// Says from which place of a route no way leads to where the vehicle may surface.
[[nodiscard]] Infeasible explain_no_escape(const cost::Sea& sea, const PlanRequest& request,
                                           geo::PlanePoint place, core::Seconds when);

[[nodiscard]] Infeasible explain_cancelled(const PlanRequest& request);

/// A stop, by its name in the inputs, at another place.
[[nodiscard]] Change move_of(const std::string& input, geo::LonLat from, geo::LonLat to);
[[nodiscard]] Infeasible explain_too_large(double vertices, const PlanRequest& request);
[[nodiscard]] Infeasible explain_too_many_icebergs(std::size_t icebergs, const PlanRequest& request);

}  // namespace floeplan::planning::search

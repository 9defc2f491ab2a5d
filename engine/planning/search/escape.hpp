#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/cost/layout.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/surfacing_plan.hpp"

namespace floeplan::planning::search {

/// The fastest way from each point of a route to a place where the vehicle may surface when it arrives. Each has a search of
/// its own, on at most 200 steps of the grid in every direction. Where the route itself is no slower, the way follows it.
/// Where the time without surfacing is bounded, the way keeps within what is left of it.
/// Drives   along the route those of its legs, elsewhere the sea's first drive
/// Precondition  `arrivals`, `drives` and `waypoints` are those of the route
/// Errors   Reason::no_escape at the first point without such a way; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<std::vector<EscapeWay>> plan_escapes(const cost::Sea& sea, const cost::Layout& layout,
                                                          const PlanRequest& request,
                                                          const std::vector<geo::PlanePoint>& route,
                                                          const std::vector<core::Seconds>& arrivals,
                                                          const std::vector<vehicle::Drive>& drives,
                                                          const std::vector<SurfacingState>& waypoints,
                                                          const std::stop_token& stop);

}  // namespace floeplan::planning::search

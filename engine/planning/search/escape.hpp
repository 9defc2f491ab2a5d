#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/cost/layout.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/problem/surfacing_plan.hpp"

namespace floeplan::planning::search {

/// The fastest route from each point of a route to a place where the vehicle may surface on arrival. Each
/// escape route has its own search, on at most 200 grid steps in every direction. If the planned route itself
/// is no slower, the escape follows it. If the time without surfacing is limited, the escape must keep the
/// remaining time.
/// Propulsion  along the route that of its legs, elsewhere the first one of the model
/// Precondition  `arrivals`, `drives` and `waypoints` are those of the route
/// Errors   Reason::no_escape at the first point without such a route; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<std::vector<EscapeWay>> plan_escapes(const cost::Sea& sea, const cost::Layout& layout,
                                                          const PlanRequest& request,
                                                          const std::vector<geo::PlanePoint>& route,
                                                          const std::vector<core::Seconds>& arrivals,
                                                          const std::vector<vehicle::Drive>& drives,
                                                          const std::vector<SurfacingState>& waypoints,
                                                          const std::stop_token& stop);

}  // namespace floeplan::planning::search

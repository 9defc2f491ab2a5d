#pragma once

#include <optional>
#include <stop_token>

#include "engine/planning/cost/route.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/refinement_report.hpp"

namespace floeplan::planning::publish {

/// The route to publish, and the figures of its refinement.
struct Improved {
  cost::Route route;
  std::optional<RefinementReport> refinement;
};

/// Improves the route along the grid before it is published: drops needless points, moves the others, reduces
/// their number, and divides long legs as the request demands. If the refined route is closed as a whole, the
/// straightened one is taken; if that is closed, too, the route along the grid.
/// Stops  refinement when the work of the request's `refine_time` is done or `stop` is requested
[[nodiscard]] Improved improve(const cost::Sea& sea, const cost::Route& way, const PlanRequest& request,
                               const std::stop_token& stop);

}  // namespace floeplan::planning::publish

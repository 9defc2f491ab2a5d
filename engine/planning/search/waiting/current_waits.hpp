#pragma once

#include <stop_token>

#include "engine/graph/search_tree.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/grid/search_outcome.hpp"

namespace floeplan::planning::search {

/// Replaces the way of a search by one that waits until a current slackens, if it arrives earlier and the request
/// allows waits: in front of a leg that is closed, or at the start.
/// Returns  by `result`, whose LateOpening such a way takes away; cancelled once `stop` is requested
void look_for_waits_in_currents(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open,
                                const graph::Query& query, const StraightBound& straight,
                                const std::stop_token& stop, const graph::ExpansionCallback& report);

}  // namespace floeplan::planning::search

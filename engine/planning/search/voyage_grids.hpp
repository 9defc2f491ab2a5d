#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/cost/route_grid.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// Each grid of a voyage, one after the other, laid into the sea as by `open_grid`; where the time without surfacing is
/// bounded they also tell how much of it the way on from each goal takes at least.
/// Stops    as `open_grid`
[[nodiscard]] std::vector<OpenGrid> open_grids(const cost::Sea& sea,
                                               const std::vector<cost::RouteGrid>& grids, int sectors,
                                               const std::stop_token& stop);

}  // namespace floeplan::planning::search

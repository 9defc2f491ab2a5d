#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/cost/route_grid.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// The grids from stop to stop in order, each made by `open_grid`. If the time without surfacing is limited,
/// each also has the least part of the limit that must be left at its goal.
/// Stops    as `open_grid`
[[nodiscard]] std::vector<OpenGrid> open_grids(const cost::Sea& sea,
                                               const std::vector<cost::RouteGrid>& grids, int sectors,
                                               const std::stop_token& stop);

}  // namespace floeplan::planning::search

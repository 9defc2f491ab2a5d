#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// The latest departure from the first grid's start that reaches the last grid's goal by `arrive` on the legs of the
/// grids: a time-reversed search from the goal. Exact under FIFO.
/// Returns  empty if there is none at or after `earliest`, or once `stop` is requested
[[nodiscard]] std::optional<core::Seconds> latest_departure(const cost::Sea& sea,
                                                            const std::vector<OpenGrid>& grids,
                                                            core::Seconds arrive, core::Seconds earliest,
                                                            const std::stop_token& stop);

/// The same on one grid.
[[nodiscard]] std::optional<core::Seconds> latest_departure(const cost::Sea& sea, const OpenGrid& open,
                                                            core::Seconds arrive, core::Seconds earliest,
                                                            const std::stop_token& stop);

}  // namespace floeplan::planning::search

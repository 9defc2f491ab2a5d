#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// The latest departure from the start of the first grid that reaches the goal of the last grid by `arrive`.
/// A time-reversed search from the goal along the grids' edges; exact under FIFO (a later departure never
/// arrives earlier).
/// Returns  empty if there is none at or after `earliest`, or once `stop` is requested
[[nodiscard]] std::optional<core::Seconds> latest_departure(const cost::Sea& sea,
                                                            const std::vector<OpenGrid>& grids,
                                                            core::Seconds arrive, core::Seconds earliest,
                                                            const std::stop_token& stop);

/// The latest departure on a single grid.
[[nodiscard]] std::optional<core::Seconds> latest_departure(const cost::Sea& sea, const OpenGrid& open,
                                                            core::Seconds arrive, core::Seconds earliest,
                                                            const std::stop_token& stop);

}  // namespace floeplan::planning::search

#pragma once

#include <stop_token>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/holding/hold_search.hpp"

namespace floeplan::planning::search {

/// Looks for a route that reaches the goal at about `arrive` and holds only at the start, that is, departs
/// later. A later departure costs nothing, and the start is the safest place to wait. Method: a time-reversed
/// search from the goal with true leg times. If none is found, a route with holds elsewhere may still exist.
/// Returns  a route timed with all closures that arrives at most a minute after `arrive`; empty: none was
///          found
/// Stops    early once `stop` is requested, and says so
[[nodiscard]] HeldWay search_later_departure(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                                             core::Seconds arrive, const std::stop_token& stop);

}  // namespace floeplan::planning::search

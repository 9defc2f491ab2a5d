#pragma once

#include <stop_token>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/holding/hold_search.hpp"

namespace floeplan::planning::search {

/// Looks for a way that is at the goal about then and on which the vehicle holds nowhere but at the start: who departs
/// later loses nothing, and waits for the goal where it is safest. Searches from the goal on the film run backwards, by
/// true times.
/// It is no proof that there is no way with holds elsewhere.
/// Returns  a way that was timed with all that closes, no later than a minute after `arrive`; empty: none was found
/// Stops    early and says so once `stop` is requested
[[nodiscard]] HeldWay search_later_departure(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                                             core::Seconds arrive, const std::stop_token& stop);

}  // namespace floeplan::planning::search

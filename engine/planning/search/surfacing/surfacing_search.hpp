#pragma once

#include <functional>
#include <stop_token>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/grid/search_outcome.hpp"

namespace floeplan::planning::search {

/// Limits on the arrivals (labels) that each search with a limit on the time without surfacing keeps: some
/// seconds and some ten megabytes.
struct SurfacingBudget {
  std::size_t any_way{100'000};
  std::size_t best_way{100'000};
};

/// The earliest arrival at the goal of a grid on routes that keep the request's limit on the time without
/// surfacing everywhere. Each label carries its arrival and the time of its last possible surfacing: a later
/// arrival through open water may be the only one that can go on.
/// Exact    The limit is always kept. In currents and ice that do not change with time, the result is no
///          later than the earliest route for a limit shorter by a hundredth, apart from the tolerance of the
///          leg times. Otherwise an arrival that is earlier, and no worse in its last possible surfacing,
///          counts as better, although a later one might meet a faster current or newly open ice
/// Waits    Where the request allows holds, the shortest hold before a leg until a closure ends. A hold below
///          ice counts as time without surfacing. A search with holds stops at a lower number of labels
/// Method   First any route that keeps the limit, by weighted A* on the part of the grid that SurfacingReach
///          leaves; then better ones with higher and higher accuracy
/// Stops    early once `stop` is requested or the budget is used up, and says so, with the best route known,
///          if any
/// Source   Pohl 1970, Heuristic search viewed as path finding in a graph, doi:10.1016/0004-3702(70)90007-X
///          (weighted A*)
[[nodiscard]] RouteSearch search_with_surfacings(const cost::Sea& sea, const OpenGrid& open,
                                                 core::Seconds depart, core::Seconds since_surfacing,
                                                 const std::stop_token& stop,
                                                 const std::function<void(double)>& report_fraction,
                                                 SurfacingBudget budget = {});

}  // namespace floeplan::planning::search

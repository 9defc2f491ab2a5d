#pragma once

#include <functional>
#include <stop_token>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/grid/search_outcome.hpp"

namespace floeplan::planning::search {

/// How many arrivals the searches with a bound on the time without surfacing keep at most, each of them: some seconds
/// and some ten megabytes.
struct SurfacingBudget {
  std::size_t any_way{100'000};
  std::size_t best_way{100'000};
};

/// The earliest arrival at the goal of a grid along ways on which the time without a possible surfacing stays within
/// the request's bound, everywhere on the way: a search over arrivals that also carries that time, because a way that
/// passes open water may be the only one that goes on.
/// Exact    as to the bound: what is found keeps it. As to time: it is no later than the earliest way that keeps a
///          bound shorter by a hundredth part, but for the tolerance of the legs' times, where currents and ice do not
///          change with time. Where they do, an arrival that is earlier and no worse as to its last possible surfacing
///          is held to be better; it may be that a later one would meet a faster current, or ice that has opened since
/// Waits    where the request allows them, the least before a leg that lets the vehicle through what is closed for a
///          while; time spent so below ice counts as time without a surfacing. The search is then
///          cut short much earlier
/// Method   first any way that keeps the bound, over what SurfacingReach leaves of the grid and by weighted A*; then
///          what may be better than it, in ever less haste
/// Stops    early and says so once `stop` is requested or beyond the budget, then with the best way it knows, if any
/// Source   Pohl 1970, Heuristic search viewed as path finding in a graph, doi:10.1016/0004-3702(70)90007-X (weighted
///          A*)
[[nodiscard]] RouteSearch search_with_surfacings(const cost::Sea& sea, const OpenGrid& open,
                                                 core::Seconds depart, core::Seconds since_surfacing,
                                                 const std::stop_token& stop,
                                                 const std::function<void(double)>& report_fraction,
                                                 SurfacingBudget budget = {});

}  // namespace floeplan::planning::search

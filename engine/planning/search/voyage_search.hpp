#pragma once

#include <cmath>
#include <functional>
#include <stop_token>
#include <vector>

#include "engine/planning/cost/sea.hpp"
#include "engine/planning/cost/straightening.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/grid/open_grid.hpp"
#include "engine/planning/search/route_search.hpp"

namespace floeplan::planning::search {

/// The way from stop to stop as the grids give it.
struct FoundWay {
  cost::Route route;
  core::Seconds arrival{};
  SearchStatistics statistics;
  bool touches_rim{false};  // it keeps to the rim of a grid, beyond which a better way may lie
};

/// What is known from the departures before, or from other searches, on the same grids.
struct OtherDepartures {
  const FoundWay* way{};                 // of one of them
  std::vector<Foresight>* foresights{};  // one for each grid
  const RouteSearch* first{};            // of the first grid, by the same method from the same departure
  core::Seconds of_use{INFINITY};        // an arrival at the last stop after which no way is wanted
};

/// Searches grid after grid with the request's method (not Method::direct), from `depart` on (counted from the
/// sea's epoch); under FIFO the earliest arrival at each stop is the best departure from it.
/// Where the time without surfacing is bounded and the way on from a stop does not keep that bound, the stop is come to
/// again, later, with as much of the bound left as the way on needs.
/// `others`: bound the search and, but for `of_use`, change no result (their way not where something closes for a while); without a way
/// legs that open later are looked for.
/// Errors   where and why there is no way
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<FoundWay> search_voyage(const cost::Sea& sea, const std::vector<OpenGrid>& grids,
                                             const PlanRequest& request, core::Seconds depart,
                                             const std::stop_token& stop,
                                             const std::function<void(double)>& report_fraction,
                                             const OtherDepartures& others = {});

/// Whether a way keeps to the rim of its grid, beyond which a better way may lie.
[[nodiscard]] bool touches_rim(const std::vector<geo::PlanePoint>& path, const cost::RouteGrid& grid);

}  // namespace floeplan::planning::search

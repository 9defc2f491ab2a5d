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

/// A route from stop to stop along the edges of the grids.
struct FoundWay {
  cost::Route route;
  core::Seconds arrival{};
  SearchStatistics statistics;
  bool touches_rim{false};  // the route follows the rim of a grid, so a better one may lie outside
};

/// Results of earlier departures, or of other searches, on the same grids.
struct OtherDepartures {
  const FoundWay* way{};                 // route of one of the other departures
  std::vector<Foresight>* foresights{};  // one for each grid
  const RouteSearch* first{};            // on the first grid, same method and departure
  core::Seconds of_use{INFINITY};        // later arrivals at the last stop are not wanted
};

/// Searches one grid after another with the request's method (not Method::direct), from `depart` on, counted
/// from the epoch of the leg cost model. Under FIFO the earliest arrival at each stop is the best departure
/// from it. If the time without surfacing is limited and the route onward from a stop exceeds the limit, the
/// part before the stop is searched again. It then arrives later, with as much of the limit left as the route
/// onward needs.
/// `others`: speed up the search and change no result, except for `of_use`. Their route is used only where no
/// closure ends. If no route is found, legs that open later are searched too.
/// Errors   where and why there is no route
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<FoundWay> search_voyage(const cost::Sea& sea, const std::vector<OpenGrid>& grids,
                                             const PlanRequest& request, core::Seconds depart,
                                             const std::stop_token& stop,
                                             const std::function<void(double)>& report_fraction,
                                             const OtherDepartures& others = {});

/// Whether a route follows the rim of its grid; a better route may then lie beyond.
[[nodiscard]] bool touches_rim(const std::vector<geo::PlanePoint>& path, const cost::RouteGrid& grid);

}  // namespace floeplan::planning::search

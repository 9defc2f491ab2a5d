#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/planning/cost/driven_route.hpp"
#include "engine/planning/cost/sea.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"
#include "engine/planning/search/energy/cost_outlook.hpp"
#include "engine/planning/search/grid/open_grid.hpp"

namespace floeplan::planning::search {

/// The route of least cost by the request's objective, from stop to stop on the grids.
struct CostWay {
  cost::DrivenRoute route;
  SearchStatistics statistics;
  bool touches_rim{false};  // the route follows the rim of a grid, so a better one may lie outside
};

/// Results about one grid that searches for the least cost share; kept between departures to save work.
/// Threads  one at a time
class CostGuide {
 public:
  /// `sea` and `open` are borrowed and must outlive this. `ahead`: time from the first departure to the last
  /// one.
  CostGuide(const cost::Sea& sea, const OpenGrid& open, core::Seconds ahead = core::Seconds{0.0})
      : sea_{sea}, open_{open}, ahead_{ahead}, foresight_{sea, open} {}

  [[nodiscard]] Foresight& foresight() { return foresight_; }
  /// The outlook for routes between `depart` and `last`. It is computed at the first call, and again for
  /// times that it does not cover.
  /// Precondition: the foresight is useful. Once `stop` is requested the guide must not be used.
  [[nodiscard]] const CostOutlook& outlook(const Objective& objective, core::Seconds depart,
                                           core::Seconds last, const std::stop_token& stop);

 private:
  const cost::Sea& sea_;
  const OpenGrid& open_;
  core::Seconds ahead_;
  Foresight foresight_;
  std::optional<CostOutlook> outlook_;
  core::Seconds from_{};  // period of the outlook
  core::Seconds until_{};
};

/// Searches grid after grid for the least cost to the next stop, departing at the arrival at the stop before.
/// The result is the best between two stops. Over several stops a better route may exist, because each search
/// knows only its own grid. If a search finds no route, the route of the earliest arrival is taken, each leg
/// with its best propulsion.
/// Accuracy on grids of few vertices as accurate as CostVoyage. On larger grids an outlook steers the search, and
/// the cost is mostly within a hundredth of the least cost
/// `guides` one for each of these grids; null: they are made for this call only
/// Errors   where and why there is no route
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<CostWay> search_least_cost(const cost::Sea& sea, const std::vector<OpenGrid>& grids,
                                                const PlanRequest& request, core::Seconds depart,
                                                const std::stop_token& stop,
                                                const std::function<void(double)>& report_fraction,
                                                std::vector<CostGuide>* guides = nullptr);

}  // namespace floeplan::planning::search

#include "engine/planning/search/holding/hold_search.hpp"

#include <algorithm>

#include "engine/planning/cost/held_schedule.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/sea_intervals.hpp"
#include "engine/planning/search/bounds/favourable_bound.hpp"

namespace floeplan::planning::search {
namespace {

/// An earlier arrival is not looked for where it would gain less: a share of the time of the straight way in slack
/// water, and no more than what is known of when places open.
constexpr double least_gain_by_holds = 1e-3;
constexpr double most_left_s = 60.0;

}  // namespace

core::Seconds slack_of_holds(const cost::Sea& sea, const OpenGrid& open) {
  const core::Metres straight{
      geo::distance_m(open.grid.point(open.grid.start), open.grid.point(open.grid.goal))};
  return core::Seconds{std::min(most_left_s, least_gain_by_holds * (straight / sea.through_water()).count())};
}

HeldWay search_held_way(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                        core::Seconds latest, const std::stop_token& stop,
                        const graph::ExpansionCallback& report, graph::IntervalLimits limits) {
  HeldWay held;
  const core::Metres straight{
      geo::distance_m(open.grid.point(open.grid.start), open.grid.point(open.grid.goal))};
  const core::Seconds last = std::min(latest, cost::end_of_looks(sea, depart, straight));
  const FavourableBound bound{sea, open, stop};
  cost::SeaIntervals model{sea, open.grid, bound, open.grid.start, {depart, last}};
  const graph::Query query{open.grid.start, open.grid.goal, depart, last};
  limits.slack_s = slack_of_holds(sea, open).count();
  const graph::IntervalSearch search =
      graph::find_earliest_among_intervals(open.graph, query, model, limits, stop, report);
  held.counters = search.counters;
  held.leg_times = leg_times_of_a_look * search.counters.edge_evaluations;
  held.cancelled = search.stopped || stop.stop_requested();
  held.full = search.full;
  held.none_before = core::Seconds{search.none_before_s};
  if (held.cancelled || search.way.empty()) return held;
  for (const graph::Visit& visit : search.way) held.path.push_back(open.grid.point(visit.vertex));
  const auto schedule = cost::held_schedule(sea, held.path, depart);
  if (!schedule) {
    held.path.clear();
    return held;
  }
  held.arrival = schedule->arrivals.back();
  return held;
}

}  // namespace floeplan::planning::search

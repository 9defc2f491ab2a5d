#include "engine/planning/search/holding/hold_search.hpp"

#include <algorithm>

#include "engine/planning/cost/held_schedule.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/sea_intervals.hpp"
#include "engine/planning/search/bounds/favourable_bound.hpp"

namespace floeplan::planning::search {
namespace {

/// An earlier arrival is searched only if it gains at least this share of the time of the straight route in
/// slack water. At most the tolerance of computed reopenings counts.
constexpr double least_gain_by_holds = 1e-3;
constexpr double most_left_s = 60.0;

/// The first search allows arrivals later than the least possible time by this share of it. After each search
/// without a result the share grows by the factor below. Both are judgements.
constexpr double looked_for_first = 0.02;
constexpr double then_further = 4.0;

/// Bound of the search: every edge takes its least time, and only vertices count from which the goal can be
/// reached in time.
struct TowardsGoalInTime {
  const FavourableBound& favourable;
  const graph::SearchTree& earliest;    // lower bounds of the arrivals at vertices
  const graph::SearchTree& until_when;  // latest useful times at vertices, from the time-reversed search

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds depart) const {
    return favourable.least_time(edge, depart);
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const { return favourable.remaining(v); }
  [[nodiscard]] TimeSpan of_use(graph::Vertex v) const {
    return {core::Seconds{earliest.arrival_s(v)},
            core::Seconds{rounding_of_times_s - until_when.arrival_s(v)}};
  }
};

/// Searches for an early arrival first, then for later ones. With an early limit few places are useful, each
/// for a short time, so the search is quick.
class HeldWaySearch {
 public:
  /// `within`: from the departure to the latest arrival. All references are borrowed.
  HeldWaySearch(const cost::Sea& sea, const OpenGrid& open, Foresight& foresight, TimeSpan within,
                const std::stop_token& stop, const graph::ExpansionCallback& report,
                const graph::IntervalLimits& limits)
      : sea_{sea},
        open_{open},
        foresight_{foresight},
        within_{within},
        stop_{stop},
        report_{report},
        limits_{limits} {}

  HeldWay run() {
    const graph::SearchTree earliest = foresight_.sweep_forth(within_.from, within_.until, stop_);
    const core::Seconds least{earliest.arrival_s(open_.grid.goal)};
    held_.none_before = least;
    const bool hopeless = least + core::Seconds{limits_.slack_s} >= within_.until;
    if (hopeless || stop_.stop_requested()) return ended();
    const FavourableBound& favourable = foresight_.at_any_time(stop_).to_goal;
    core::Seconds more = looked_for_first * (least - within_.from);
    for (core::Seconds arrive = within_.from; arrive < within_.until && !is_over(); more *= then_further) {
      arrive = std::min(least + more, within_.until);
      const graph::SearchTree until_when = foresight_.sweep_back(within_.from, arrive, stop_, earliest);
      if (stop_.stop_requested()) break;
      look_for(arrive, {favourable, earliest, until_when});
    }
    return ended();
  }

 private:
  void look_for(core::Seconds arrive, const TowardsGoalInTime& bound) {
    cost::SeaIntervals model{sea_, open_.grid, bound, within_.from};
    const graph::Query query{open_.grid.start, open_.grid.goal, within_.from, arrive};
    graph::IntervalLimits left = limits_;
    left.most_looks -= held_.counters.edge_evaluations;
    const graph::IntervalSearch found =
        graph::find_earliest_among_intervals(open_.graph, query, model, left, stop_, report_);
    held_.counters.expansions += found.counters.expansions;
    held_.counters.edge_evaluations += found.counters.edge_evaluations;
    held_.cancelled = found.stopped;
    held_.full = found.full;
    held_.none_before = found.full ? core::Seconds{found.none_before_s} : arrive;
    way_ = found.way;
  }

  [[nodiscard]] bool is_over() const {
    return !way_.empty() || held_.full || held_.cancelled || stop_.stop_requested();
  }

  HeldWay ended() {
    held_.leg_times = leg_times_of_a_look * held_.counters.edge_evaluations;
    held_.cancelled = held_.cancelled || stop_.stop_requested();
    if (held_.cancelled || way_.empty()) return std::move(held_);
    for (const graph::Visit& visit : way_) held_.path.push_back(open_.grid.point(visit.vertex));
    const auto schedule = cost::held_schedule(sea_, held_.path, within_.from);
    if (schedule) {
      held_.arrival = schedule->arrivals.back();
    } else {
      held_.path.clear();
    }
    return std::move(held_);
  }

  const cost::Sea& sea_;
  const OpenGrid& open_;
  Foresight& foresight_;
  TimeSpan within_;
  const std::stop_token& stop_;
  const graph::ExpansionCallback& report_;
  graph::IntervalLimits limits_;
  std::vector<graph::Visit> way_;
  HeldWay held_;
};

}  // namespace

core::Seconds slack_of_holds(const cost::Sea& sea, const OpenGrid& open) {
  const core::Metres straight{
      geo::distance_m(open.grid.point(open.grid.start), open.grid.point(open.grid.goal))};
  return core::Seconds{std::min(most_left_s, least_gain_by_holds * (straight / sea.through_water()).count())};
}

HeldWay search_held_way(const cost::Sea& sea, const OpenGrid& open, Foresight& foresight,
                        core::Seconds depart, core::Seconds latest, const std::stop_token& stop,
                        const graph::ExpansionCallback& report, graph::IntervalLimits limits) {
  const core::Metres straight{
      geo::distance_m(open.grid.point(open.grid.start), open.grid.point(open.grid.goal))};
  const core::Seconds last = std::min(latest, cost::end_of_looks(sea, depart, straight));
  limits.slack_s = slack_of_holds(sea, open).count();
  return HeldWaySearch{sea, open, foresight, {depart, last}, stop, report, limits}.run();
}

}  // namespace floeplan::planning::search

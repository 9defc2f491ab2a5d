#include "engine/planning/search/waiting/current_waits.hpp"

#include <algorithm>
#include <optional>

#include "engine/graph/label_setting_search.hpp"
#include "engine/planning/cost/loiter.hpp"

namespace floeplan::planning::search {
namespace {

/// Looks for ways that wait until a current slackens, and takes those that arrive earlier.
class WaitsInCurrents {
 public:
  WaitsInCurrents(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open,
                  const StraightBound& straight, const std::stop_token& stop,
                  const graph::ExpansionCallback& report)
      : result_{result}, sea_{sea}, open_{open}, straight_{straight}, stop_{stop}, report_{report} {}

  /// In front of each leg that a current closes.
  void look_on_the_way(const graph::Query& query) { search(query, WaitedTravelTime{sea_, open_.grid}); }

  /// At the start: whoever is early where the current lets in, but does not let out, blocks a place for the later ones.
  void look_at_the_start(const graph::Query& query) {
    constexpr int most_tries = 24;
    const geo::PlanePoint start = open_.grid.point(open_.grid.start);
    const core::Seconds stays =
        cost::can_stay_until(sea_, start, query.depart, query.depart + sea_.longest_wait());
    const core::Seconds least = sea_.least_time(start, open_.grid.point(open_.grid.goal));
    const core::Seconds fine = cost::between_tries(sea_, stays - query.depart);
    const core::Seconds between = std::max(fine, (stays - query.depart) / most_tries);
    const auto helps = [&](core::Seconds depart) {
      graph::Query later = query;
      later.depart = depart;
      if (!result_.path.empty()) later.latest = std::min(later.latest, result_.arrival);
      return search(later, GridTravelTime{sea_, open_.grid});
    };
    std::optional<core::Seconds> best;
    for (core::Seconds depart = query.depart + between; depart <= stays && !result_.cancelled;
         depart += between) {
      if (!result_.path.empty() && depart + least >= result_.arrival) break;
      if (helps(depart)) best = depart;
    }
    if (!best) return;
    core::Seconds earlier = *best - between;
    while (*best - earlier > fine && !result_.cancelled) {
      const core::Seconds middle = 0.5 * (earlier + *best);
      (helps(middle) ? *best : earlier) = middle;
    }
  }

 private:
  /// Returns  whether there is an earlier way
  template <class TravelTime>
  bool search(const graph::Query& query, const TravelTime& travel_time) {
    const graph::SearchTree tree =
        graph::find_earliest_arrivals(open_.graph, query, travel_time, stop_, straight_, report_);
    result_.cancelled = tree.stopped;
    result_.statistics.edge_evaluations += tree.counters.edge_evaluations;
    result_.statistics.expansions += tree.counters.expansions;
    const core::Seconds arrival{tree.arrival_s(open_.grid.goal)};
    if (tree.stopped || !tree.is_reached(open_.grid.goal) ||
        (!result_.path.empty() && arrival >= result_.arrival))
      return false;
    result_.path.clear();
    for (const graph::Vertex v : graph::path_to(open_.graph, tree, open_.grid.goal))
      result_.path.push_back(open_.grid.point(v));
    result_.arrival = arrival;
    result_.statistics.worst_fifo_violation.reset();  // who may wait loses nothing by it
    return true;
  }

  RouteSearch& result_;
  const cost::Sea& sea_;
  const OpenGrid& open_;
  const StraightBound& straight_;
  const std::stop_token& stop_;
  const graph::ExpansionCallback& report_;
};

}  // namespace

void look_for_waits_in_currents(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open,
                                const graph::Query& query, const StraightBound& straight,
                                const std::stop_token& stop, const graph::ExpansionCallback& report) {
  if (!cost::waits_may_help(sea)) return;
  WaitsInCurrents waits{result, sea, open, straight, stop, report};
  waits.look_on_the_way(query);
  if (!result.cancelled && !sea.overhead().bounds_surfacing()) waits.look_at_the_start(query);
}

}  // namespace floeplan::planning::search

#include "engine/planning/search/holding/later_departure.hpp"

#include <algorithm>
#include <utility>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/search/bounds/favourable_bound.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"

namespace floeplan::planning::search {
namespace {

constexpr core::Seconds nearly_then{60.0};

/// Bound of the time-reversed search: the least time to the start, and at each place no earlier than the
/// fastest vehicle with the strongest current from astern can be there.
struct TowardsStart {
  const FavourableBound& from_start;
  core::Seconds depart;

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds when) const {
    return from_start.least_time(edge, when);
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const { return from_start.remaining(v); }
  [[nodiscard]] core::Seconds latest_use(graph::Vertex v) const { return -(depart + remaining(v)); }
};

}  // namespace

HeldWay search_later_departure(const cost::Sea& sea, const OpenGrid& open, core::Seconds depart,
                               core::Seconds arrive, const std::stop_token& stop) {
  HeldWay held;
  const core::Seconds then = arrive + 0.5 * nearly_then;  // reopenings shortly after `arrive` count, too
  const graph::Query query{
      .source = open.grid.goal, .goal = open.grid.start, .depart = -then, .latest = -depart};
  const FavourableBound from_start{sea, open, stop, FavourableBound::Way::from_start};
  const graph::SearchTree back = graph::find_earliest_arrivals(
      open.graph, query, GridTravelTimeBack{sea, open.grid}, stop, TowardsStart{from_start, depart});
  held.counters = back.counters;
  held.leg_times = back.counters.edge_evaluations;
  held.cancelled = back.stopped || stop.stop_requested();
  std::vector<geo::PlanePoint> way;
  for (const graph::Vertex v : graph::path_to(open.graph, back, open.grid.start))
    way.push_back(open.grid.point(v));
  if (held.cancelled || way.empty()) return held;
  std::ranges::reverse(way);
  const auto schedule = cost::schedule_along(sea, way, depart);
  if (!schedule || schedule->arrivals.back() > arrive + nearly_then) return held;
  held.path = std::move(way);
  held.arrival = schedule->arrivals.back();
  return held;
}

}  // namespace floeplan::planning::search

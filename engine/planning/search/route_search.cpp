#include "engine/planning/search/route_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/graph/time_dependent_astar.hpp"
#include "engine/graph/tve_search.hpp"
#include "engine/planning/cost/hold_times.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "engine/planning/search/holding/hold_search.hpp"
#include "engine/planning/search/holding/later_departure.hpp"
#include "engine/planning/search/surfacing/surfacing_search.hpp"

namespace floeplan::planning::search {
namespace {

using graph::Edge;
using graph::Vertex;

/// Edge travel times for the paper's left column: every edge has the travel time of the departure from the
/// start.
struct FrozenTravelTime {
  GridTravelTime now;
  core::Seconds depart;

  tl::expected<core::Seconds, motion::EdgeClosed> operator()(const Edge& edge, core::Seconds,
                                                             core::Seconds) const {
    return now(edge, depart, core::Seconds{INFINITY});
  }
};

/// Adds the counts of an earlier search.
void add_work(SearchStatistics& sum, const SearchStatistics& earlier) {
  sum.expansions += earlier.expansions;
  sum.edge_evaluations += earlier.edge_evaluations;
  sum.reinsertions += earlier.reinsertions;
}

/// The true arrival of a route that is probably close to the best; infinite if no open one is found.
/// `timed_closures`: whether the travel times include closures that end
template <class TravelTime>
core::Seconds likely_arrival(Foresight& foresight, const TravelTime& travel_time, bool timed_closures,
                             core::Seconds depart, const std::stop_token& stop) {
  constexpr std::size_t most_barred =
      8;  // attempts; each avoids the edge that closed the one before, far quicker than a search
  constexpr core::Seconds never{INFINITY};
  Foresight::Minding minding{.timed_closures = timed_closures};
  while (minding.barred.size() < most_barred) {
    const std::vector<Edge> way = foresight.likely_way(depart, stop, minding);
    if (way.empty()) return never;
    core::Seconds now = depart;
    const auto closed = std::ranges::find_if(way, [&](const Edge& edge) {
      const auto time = travel_time(edge, now, never);
      if (time) now += *time;
      return !time;
    });
    if (closed == way.end()) return now;
    minding.barred.push_back(*closed);
  }
  return never;
}

void describe_end(RouteSearch& result, const cost::Sea& sea, const cost::RouteGrid& grid,
                  const graph::GridGraph& graph, const graph::SearchTree& tree) {
  const geo::PlanePoint goal = grid.point(grid.goal);
  Vertex nearest = grid.start;
  double least = std::numeric_limits<double>::infinity();
  for (Vertex v = 0; v < graph.size(); ++v) {
    if (!tree.is_reached(v)) continue;
    const geo::PlanePoint point = grid.point(v);
    const double distance = geo::distance_m(point, goal);
    if (distance < least) {
      least = distance;
      nearest = v;
    }
  }
  result.nearest = grid.point(nearest);
  result.nearest_arrival = core::Seconds{tree.is_reached(nearest) ? tree.arrival_s(nearest) : 0.0};
  for (const graph::Offset offset : graph.offsets()) {
    const geo::PlanePoint head{result.nearest.x_m + offset.dx * grid.along.x_m + offset.dy * grid.across.x_m,
                               result.nearest.y_m + offset.dx * grid.along.y_m + offset.dy * grid.across.y_m};
    const auto time = sea.leg_time(result.nearest, head, result.nearest_arrival);
    if (time) continue;
    result.closed_at_nearest.push_back(time.error());
    if (time.error() == motion::EdgeClosed::outside_data &&
        !sea.domain().safety().closed_between(result.nearest, head) &&
        sea.domain().currents_known_to_end(head, result.nearest_arrival)) {
      result.out_of_time = true;
    }
  }
}

/// The best route when closures that end are ignored, timed with all closures.
struct UntimedWay {
  bool is_best{false};         // no closure delays it
  double arrival_s{INFINITY};  // with the holds that the closures need; infinite if it is closed
};

UntimedWay timed_without_delay(const cost::Sea& sea, const std::vector<geo::PlanePoint>& path,
                               core::Seconds depart, double least_s) {
  if (path.empty()) return {};
  const auto schedule = cost::schedule_along(sea, path, depart);
  if (!schedule) return {};
  const bool waits =
      std::ranges::any_of(schedule->waits, [](core::Seconds wait) { return wait.count() > 0.0; });
  return {!waits, std::max(least_s, schedule->arrivals.back().count())};
}

/// Whether a leg that the current closed may open in time: a vehicle that holds until then may still reach
/// the goal before `arrival`.
bool may_open_in_time(const RefusedEdges& refused, const StraightBound& straight, core::Seconds arrival) {
  return std::ranges::any_of(refused.edges, [&](const RefusedEdge& leg) {
    return leg.when + straight.least_time(leg.edge) + straight.remaining(leg.edge.head) < arrival;
  });
}

/// Limit of the search for a route with holds if a route is already known: about half a second.
constexpr std::int64_t most_looks_for_better = 100'000;

/// Takes the route with holds if it arrives earlier.
void take_earlier(RouteSearch& result, HeldWay held) {
  result.statistics.expansions += held.counters.expansions;
  result.statistics.edge_evaluations += held.leg_times;
  result.statistics.cut_short = held.full;
  result.cancelled = held.cancelled;
  if (held.arrival < result.arrival) {
    result.path = std::move(held.path);
    result.arrival = held.arrival;
  }
  if (held.full && std::isfinite(result.arrival.count()))
    result.statistics.possible_gain = std::max(core::Seconds{0.0}, result.arrival - held.none_before);
}

/// For a goal that is closed until after the vehicle could be there: replaces the route by one that departs
/// later.
/// Returns  whether no earlier arrival is possible
bool is_best_departing_later(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open,
                             core::Seconds unhindered, core::Seconds depart, const std::stop_token& stop) {
  const std::vector<TimeSpan> closed = sea.domain().closures().closed_times(open.grid.point(open.grid.goal));
  const core::Seconds opens = open_from(closed, unhindered);
  if (!std::isfinite(opens.count()) || opens <= unhindered) return false;
  const auto is_best = [&] { return result.arrival <= opens + slack_of_holds(sea, open); };
  if (!is_best()) take_earlier(result, search_later_departure(sea, open, depart, opens, stop));
  // On another grid the vehicle might arrive slightly earlier. If the goal is also closed for the last
  // twentieth of the travel time, this makes no difference.
  constexpr double faster_at_most = 0.95;
  const bool is_closed_then = open_from(closed, depart + faster_at_most * (unhindered - depart)) == opens;
  result.statistics.none_is_earlier = is_best() && is_closed_then;
  return is_best();
}

/// The search without a limit on the time without surfacing.
RouteSearch search_unbounded(const cost::Sea& sea, const OpenGrid& open, const PlanRequest& request,
                             core::Seconds depart, const std::stop_token& stop,
                             const std::function<void(double)>& report_fraction, core::Seconds latest,
                             Foresight* kept_foresight) {
  const cost::RouteGrid& grid = open.grid;
  const graph::GridGraph& graph = open.graph;
  RouteSearch result;
  result.statistics.vertices = open.vertices;
  result.statistics.edges = open.edges;

  const graph::Query query{grid.start, grid.goal, depart, latest};
  const StraightBound straight{sea, grid, graph, grid.goal};
  RefusedEdges refused;
  const graph::ExpansionCallback report = [&](std::int64_t expansions) {
    const auto vertices = static_cast<double>(std::max<std::int64_t>(1, result.statistics.vertices));
    report_fraction(std::min(1.0, static_cast<double>(expansions) / vertices));
  };
  // Gives the same result as a search with the straight-line bound, but visits fewer vertices.
  const auto search_ahead = [&](const auto& travel_time, bool timed_closures) -> graph::SearchTree {
    const bool towards_goal = request.method == Method::astar;
    std::optional<Foresight> own_foresight;
    Foresight& foresight = kept_foresight != nullptr ? *kept_foresight : own_foresight.emplace(sea, open);
    if (foresight.is_useful()) {
      graph::Query in_time = query;
      if (std::isinf(query.latest.count())) {
        in_time.latest = likely_arrival(foresight, travel_time, timed_closures, depart, stop);
        refused.edges.clear();
      }
      if (std::isfinite(in_time.latest.count()) && !stop.stop_requested()) {
        const graph::SearchTree& until_when = foresight.until_when_of_use(depart, in_time.latest, stop);
        const ForesightBound bound{foresight, straight, until_when, towards_goal};
        graph::SearchTree tree =
            graph::find_earliest_arrivals(graph, in_time, travel_time, stop, bound, report);
        // If a latest arrival is given, reopenings do not matter.
        const bool may_open_later =
            std::isinf(query.latest.count()) &&
            std::ranges::any_of(refused.edges, [&](const RefusedEdge& leg) {
              return leg.when + straight.least_time(leg.edge) <= bound.latest_use(leg.edge.head);
            });
        if (tree.stopped || (tree.is_reached(grid.goal) && !may_open_later)) {
          refused.edges.clear();  // holding until a leg reopens would arrive too late
          return tree;
        }
      }
      refused.edges.clear();
    }
    if (towards_goal) {
      return graph::find_earliest_arrivals(graph, query, travel_time, stop, straight, report);
    }
    return graph::find_earliest_arrivals(graph, query, travel_time, stop, EdgeBound{straight}, report);
  };
  const auto search = [&](const auto& travel_time, bool timed_closures) -> graph::SearchTree {
    switch (request.method) {
      case Method::tve: return graph::find_earliest_arrivals_tve(graph, query, travel_time, stop, report);
      case Method::dijkstra:
      case Method::astar: return search_ahead(travel_time, timed_closures);
      case Method::frozen:
        return graph::find_earliest_arrivals(graph, query, FrozenTravelTime{{sea, grid}, depart}, stop,
                                             EdgeBound{straight}, report);
      case Method::direct: break;
    }
    throw std::invalid_argument{"the direct way needs no search"};
  };
  const auto adopt = [&](const graph::SearchTree& tree) {
    result.cancelled = tree.stopped;
    result.statistics.edge_evaluations += tree.counters.edge_evaluations;
    result.statistics.expansions += tree.counters.expansions;
    result.statistics.reinsertions += tree.counters.reinsertions;
    result.path.clear();
    for (const Vertex v : graph::path_to(graph, tree, grid.goal)) result.path.push_back(grid.point(v));
    result.arrival = core::Seconds{tree.arrival_s(grid.goal)};
  };

  // If no timed closure touches the best route without them, it is also the best route with them.
  const bool in_time = sea.domain().closures().any_timed() && request.method != Method::frozen;
  graph::SearchTree tree = in_time ? search(UntimedTravelTime{sea, grid, &refused}, false)
                                   : search(GridTravelTime{sea, grid, &refused}, false);
  adopt(tree);
  const auto untimed_way = in_time ? timed_without_delay(sea, result.path, depart, tree.arrival_s(grid.goal))
                                   : UntimedWay{.is_best = true, .arrival_s = tree.arrival_s(grid.goal)};
  const bool is_hindered = !result.path.empty() && !untimed_way.is_best;
  const bool opens_later = may_open_in_time(refused, straight, result.arrival);
  const bool holds_may_help = cost::holds_may_help(sea) && request.method != Method::frozen;
  if (is_hindered && !result.cancelled) {
    RouteSearch untimed = result;
    untimed.arrival = core::Seconds{untimed_way.arrival_s};  // with the holds that the closures need
    const core::Seconds unhindered{tree.arrival_s(grid.goal)};
    if (holds_may_help && is_best_departing_later(untimed, sea, open, unhindered, depart, stop))
      return untimed;
    if (untimed.cancelled) return untimed;
    tree = search(GridTravelTime{sea, grid, &refused}, true);
    adopt(tree);
    if (untimed.arrival < result.arrival) {
      result.path = std::move(untimed.path);
      result.arrival = untimed.arrival;
    }
  }
  if (holds_may_help && (is_hindered || opens_later) && !result.cancelled) {
    graph::IntervalLimits limits = limits_of_a_hold_search;
    if (!result.path.empty()) limits.most_looks = most_looks_for_better;
    take_earlier(result,
                 search_held_way(sea, open, depart, std::min(latest, result.arrival), stop, report, limits));
  }
  const bool anything_opens = sea.domain().closures().any_timed() ||
                              (sea.domain().currents() && sea.domain().currents()->time_step());
  result.statistics.holds_may_help =
      anything_opens && sea.holding().longest.count() == 0.0 && (is_hindered || opens_later);
  if (result.path.empty() && !result.cancelled) describe_end(result, sea, grid, graph, tree);
  return result;
}

}  // namespace

RouteSearch search_route(const cost::Sea& sea, const OpenGrid& open, const PlanRequest& request,
                         core::Seconds depart, const std::stop_token& stop,
                         const std::function<void(double)>& report_fraction, core::Seconds latest,
                         core::Seconds since_surfacing, Foresight* kept_foresight) {
  RouteSearch found =
      search_unbounded(sea, open, request, depart, stop, report_fraction, latest, kept_foresight);
  if (!sea.domain().overhead().bounds_surfacing() || found.cancelled || found.path.empty()) return found;
  // If the best route of all keeps the bound, it is also the best of those that do.
  const auto since = cost::since_surfacing_at_end(sea, found.path, depart, since_surfacing, found.arrival);
  if (since && *since + open.needed_after_goal() <= *sea.domain().overhead().longest_without_surfacing()) {
    found.since_surfacing = *since;
    return found;
  }
  RouteSearch bounded = search_with_surfacings(sea, open, depart, since_surfacing, stop, report_fraction);
  add_work(bounded.statistics, found.statistics);
  if (bounded.path.empty() && bounded.statistics.cut_short && sea.holding().longest.count() > 0.0) {
    // Search without holds: holds use up most of a search's labels.
    RouteSearch moving = search_with_surfacings(sea.with({.holds = false}), open, depart, since_surfacing,
                                                stop, report_fraction);
    add_work(moving.statistics, bounded.statistics);
    if (!moving.path.empty()) {
      moving.statistics.cut_short = true;  // a route with holds might arrive earlier
      return moving;
    }
  }
  return bounded;
}

}  // namespace floeplan::planning::search

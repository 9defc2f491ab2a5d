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
#include "engine/planning/search/holding/hold_anywhere.hpp"
#include "engine/planning/search/holding/hold_search.hpp"
#include "engine/planning/search/surfacing/surfacing_search.hpp"

namespace floeplan::planning::search {
namespace {

using graph::Edge;
using graph::Vertex;
using TimedClosures = Foresight::TimedClosures;

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

/// The edges of the path that a search found to the goal.
std::vector<Edge> edges_to(const graph::GridGraph& graph, const graph::SearchTree& tree, Vertex goal) {
  std::vector<Edge> way;
  const std::vector<Vertex> path = graph::path_to(graph, tree, goal);
  for (std::size_t i = 1; i < path.size(); ++i) way.push_back({path[i - 1], path[i], tree.step(path[i])});
  return way;
}

/// Follows a route with the true travel times. Returns the first edge that is closed then; past the end: none is.
template <class TravelTime>
std::vector<Edge>::const_iterator follow(const std::vector<Edge>& way, const TravelTime& travel_time,
                                         graph::SearchTree& tree) {
  return std::ranges::find_if(way, [&](const Edge& edge) {
    const core::Seconds now{tree.arrival_s(edge.tail)};
    const auto time = travel_time(edge, now, core::Seconds{INFINITY});
    if (time) tree.reach(edge, (now + *time).count());
    return !time;
  });
}

/// A route that is probably close to the best, with its true times: the goal is not reached if no open one is
/// found. `timed`: how the travel times treat closures that end
template <class TravelTime>
graph::SearchTree likely_route(Foresight& foresight, const OpenGrid& open, const TravelTime& travel_time,
                               TimedClosures timed, core::Seconds depart, const std::stop_token& stop) {
  // Attempts: each avoids the leg that closed the one before, and its ends. Far quicker than a search.
  constexpr std::size_t most_attempts = 8;
  constexpr double most_slower = 1.02;  // of the last route now: slower, and a new estimate pays
  graph::SearchTree begun{open.graph.size()};
  begun.start(open.grid.start, depart.count());
  const Foresight::KnownWay& last = foresight.last_way(timed);
  if (!last.edges.empty()) {
    graph::SearchTree tree = begun;
    const bool is_open = follow(last.edges, travel_time, tree) == last.edges.end();
    if (is_open && core::Seconds{tree.arrival_s(open.grid.goal)} - depart <= most_slower * last.time)
      return tree;
  }
  Foresight::Minding minding{.timed = timed};
  for (std::size_t attempt = 0; attempt < most_attempts; ++attempt) {
    const std::vector<Edge> way = foresight.likely_way(depart, stop, minding);
    if (way.empty()) break;
    graph::SearchTree tree = begun;
    const auto closed = follow(way, travel_time, tree);
    if (closed == way.end()) return tree;
    minding.closed.push_back(*closed);
  }
  return begun;
}

/// The reached vertex nearest to the goal.
Vertex nearest_reached(const cost::RouteGrid& grid, const graph::GridGraph& graph,
                       const graph::SearchTree& tree) {
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
  return nearest;
}

void describe_end(RouteSearch& result, const cost::Sea& sea, const cost::RouteGrid& grid,
                  const graph::GridGraph& graph, const graph::SearchTree& tree) {
  const Vertex nearest = nearest_reached(grid, graph, tree);
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

/// A route of the earliest possible arrival, timed with all closures.
struct Timed {
  bool is_best{false};         // it arrives about then
  double arrival_s{INFINITY};  // with the holds that the closures need; infinite if it is closed
};

Timed timed(const cost::Sea& sea, const OpenGrid& open, const std::vector<geo::PlanePoint>& path,
            core::Seconds depart, double least_s) {
  if (path.empty()) return {};
  const auto schedule = cost::schedule_along(sea, path, depart);
  if (!schedule) return {};
  const double arrival_s = std::max(least_s, schedule->arrivals.back().count());
  return {arrival_s <= least_s + slack_of_holds(sea, open).count(), arrival_s};
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
  std::optional<Foresight> own_foresight;
  Foresight& foresight = kept_foresight != nullptr ? *kept_foresight : own_foresight.emplace(sea, open);
  // Gives the same result as a search with the straight-line bound, but visits fewer vertices.
  const auto search_ahead = [&](const auto& travel_time, TimedClosures timed) -> graph::SearchTree {
    const bool towards_goal = request.method == Method::astar;
    if (foresight.is_useful()) {
      const FavourableBound& to_goal = foresight.at_any_time(stop).to_goal;
      graph::Query in_time = query;
      if (std::isinf(query.latest.count())) {
        graph::SearchTree likely = likely_route(foresight, open, travel_time, timed, depart, stop);
        refused.edges.clear();
        in_time.latest = core::Seconds{likely.arrival_s(grid.goal)};
        const core::Seconds earliest = foresight.open_from(grid.goal, depart + to_goal.remaining(grid.start));
        if (timed == TimedClosures::waited_for && likely.is_reached(grid.goal) &&
            in_time.latest.count() <= earliest.count() + rounding_of_times_s)
          return likely;  // the goal reopens then: nobody arrives earlier
      }
      if (std::isfinite(in_time.latest.count()) && !stop.stop_requested()) {
        const graph::SearchTree& until_when = foresight.until_when_of_use(depart, in_time.latest, stop);
        const ForesightBound bound{foresight, to_goal, until_when, towards_goal};
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
          foresight.last_way(timed) = {edges_to(graph, tree, grid.goal),
                                       core::Seconds{tree.arrival_s(grid.goal)} - depart};
          return tree;
        }
      }
      refused.edges.clear();
    }
    // Walls that always stand are found without timing any leg; this is quick and reports no progress. A search
    // for the goal would first go everywhere on this side of them; one for the place nearest to the goal says
    // when the vehicle is there.
    const graph::SearchTree past_walls =
        graph::find_earliest_arrivals(graph, query, StandingTravelTime{sea, grid, straight}, stop, straight);
    if (!past_walls.stopped && !past_walls.is_reached(grid.goal)) {
      graph::Query to_wall = query;
      to_wall.goal = nearest_reached(grid, graph, past_walls);
      graph::SearchTree tree = graph::find_earliest_arrivals(
          graph, to_wall, travel_time, stop, StraightBound{sea, grid, graph, *to_wall.goal}, report);
      refused.edges.clear();  // no hold opens a wall
      return tree;
    }
    if (towards_goal) {
      return graph::find_earliest_arrivals(graph, query, travel_time, stop,
                                           foresight.at_any_time(stop).to_goal, report);
    }
    return graph::find_earliest_arrivals(graph, query, travel_time, stop, EdgeBound{straight}, report);
  };
  const auto search = [&](const auto& travel_time, TimedClosures timed) -> graph::SearchTree {
    switch (request.method) {
      case Method::tve: return graph::find_earliest_arrivals_tve(graph, query, travel_time, stop, report);
      case Method::dijkstra:
      case Method::astar: return search_ahead(travel_time, timed);
      case Method::frozen:
        return graph::find_earliest_arrivals(graph, query, FrozenTravelTime{{sea, grid}, depart}, stop,
                                             EdgeBound{straight}, report);
      case Method::direct: break;
    }
    throw std::invalid_argument{"the direct way needs no search"};
  };
  const auto adopt = [&](const graph::SearchTree& tree) {
    result.cancelled = tree.stopped || stop.stop_requested();  // the bounds may be incomplete, too
    result.statistics.edge_evaluations += tree.counters.edge_evaluations;
    result.statistics.expansions += tree.counters.expansions;
    result.statistics.reinsertions += tree.counters.reinsertions;
    result.path.clear();
    for (const Vertex v : graph::path_to(graph, tree, grid.goal)) result.path.push_back(grid.point(v));
    result.arrival = core::Seconds{tree.arrival_s(grid.goal)};
  };

  // No vehicle arrives earlier than one that may hold anywhere, or, without holds, one that no closure stops. If
  // the vehicle of the request can travel that one's best route as early, nothing is earlier.
  const bool in_time = sea.domain().closures().any_timed() && request.method != Method::frozen;
  const bool holds_may_help = cost::holds_may_help(sea) && request.method != Method::frozen;
  const core::Metres straight_way{geo::distance_m(grid.point(grid.start), grid.point(grid.goal))};
  const auto search_freely = [&] {
    if (!in_time) return search(GridTravelTime{sea, grid, &refused}, TimedClosures::ignored);
    if (!holds_may_help) return search(UntimedTravelTime{sea, grid, &refused}, TimedClosures::ignored);
    const core::Seconds until = cost::end_of_looks(sea, depart, straight_way);
    return search(HoldAnywhereTime{sea, grid, foresight, until, &refused}, TimedClosures::waited_for);
  };
  graph::SearchTree tree = search_freely();
  adopt(tree);
  const Timed best_of_all = in_time ? timed(sea, open, result.path, depart, result.arrival.count())
                                    : Timed{.is_best = true, .arrival_s = result.arrival.count()};
  const bool is_hindered = !result.path.empty() && !best_of_all.is_best;
  const bool opens_later = may_open_in_time(refused, straight, result.arrival);
  if (in_time && best_of_all.is_best) {
    result.arrival = core::Seconds{best_of_all.arrival_s};
    // On another grid the vehicle might arrive slightly earlier. If the goal is closed for the last twentieth of
    // the travel time, this makes no difference.
    constexpr double faster_at_most = 0.95;
    const core::Seconds there = depart + faster_at_most * (result.arrival - depart);
    result.statistics.none_is_earlier =
        foresight.open_from(grid.goal, there) + slack_of_holds(sea, open) >= result.arrival;
  }
  if (is_hindered && !result.cancelled) {
    RouteSearch with_holds = result;
    with_holds.arrival = core::Seconds{best_of_all.arrival_s};
    tree = search(GridTravelTime{sea, grid, &refused}, TimedClosures::avoided);
    adopt(tree);
    if (with_holds.arrival < result.arrival) {
      result.path = std::move(with_holds.path);
      result.arrival = with_holds.arrival;
    }
  }
  if (holds_may_help && (is_hindered || opens_later) && !result.cancelled) {
    graph::IntervalLimits limits = limits_of_a_hold_search;
    if (!result.path.empty()) limits.most_looks = most_looks_for_better;
    const core::Seconds before = std::min(latest, result.arrival);
    take_earlier(result, search_held_way(sea, open, foresight, depart, before, stop, report, limits));
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

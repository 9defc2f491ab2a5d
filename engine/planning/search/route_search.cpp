#include "engine/planning/search/route_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/graph/label_setting_search.hpp"
#include "engine/graph/tve_search.hpp"
#include "engine/planning/cost/loiter.hpp"
#include "engine/planning/cost/route_cost.hpp"
#include "engine/planning/search/bounds/foresight.hpp"
#include "engine/planning/search/grid/grid_travel.hpp"
#include "engine/planning/search/holding/hold_search.hpp"
#include "engine/planning/search/surfacing/surfacing_search.hpp"
#include "engine/planning/search/waiting/late_openings.hpp"
#include "engine/planning/search/waiting/later_ways.hpp"
#include "engine/planning/search/waiting/time_killing.hpp"
#include "engine/planning/search/waiting/waiting_way.hpp"

namespace floeplan::planning::search {
namespace {

using graph::Edge;
using graph::Vertex;

/// Bounds on a search among later arrivals, each label some ten microseconds: more where no way is known yet.
constexpr std::size_t most_labels_for_a_way = 100'000;
constexpr std::size_t most_labels_for_a_better_way = 20'000;
/// Of the travel time: a better way past what opens later is not looked for where it could gain less.
constexpr double least_gain = 1e-3;
/// Likewise of what a search that ran out of labels may have missed: where it is more, a way is looked for that stays
/// at one place, which takes some seconds. A judgement.
constexpr double worth_a_wait = 0.02;

/// The paper's left column: every weight as it is at departure.
struct FrozenTravelTime {
  GridTravelTime now;
  core::Seconds depart;

  tl::expected<core::Seconds, motion::EdgeClosed> operator()(const Edge& edge, core::Seconds,
                                                             core::Seconds) const {
    return now(edge, depart, core::Seconds{INFINITY});
  }
};

/// Counts the work of an earlier search, too.
void add_work(SearchStatistics& sum, const SearchStatistics& earlier) {
  sum.expansions += earlier.expansions;
  sum.edge_evaluations += earlier.edge_evaluations;
  sum.reinsertions += earlier.reinsertions;
}

/// When a way that is likely to be about the best ends, by true times; infinite where none is found that is open.
/// `timed_closures`: whether the travel times mind what closes for a while
template <class TravelTime>
core::Seconds likely_arrival(Foresight& foresight, const TravelTime& travel_time, bool timed_closures,
                             core::Seconds depart, const std::stop_token& stop) {
  constexpr std::size_t most_barred = 8;  // each takes another way, far less work than a search without one
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
        !sea.safety().closed_between(result.nearest, head) &&
        sea.currents_known_to_end(head, result.nearest_arrival)) {
      result.out_of_time = true;
    }
  }
}

/// The best way as if nothing closed and opened in time, with all that does.
struct UntimedWay {
  bool is_best{false};         // nothing delays it
  double arrival_s{INFINITY};  // with the waits it needs; infinite when it is closed
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

/// A way as if nothing closed and opened in time.
struct AtOnce {
  std::vector<geo::PlanePoint> path;
  core::Seconds arrival;
};

/// Whether the way circles for too long; the result then says what opens too late.
bool is_refused_for_circling(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open,
                             const std::vector<geo::PlanePoint>& way, const AtOnce& at_once,
                             core::Seconds depart, const std::stop_token& stop) {
  const auto circling = circles_too_long(sea, open, way, depart, at_once.arrival, stop);
  if (!circling) return false;
  const auto closed = cost::closed_at_once(sea, at_once.path, depart);
  if (!closed) return false;
  result.opens_later = OpensLater{*closed, *circling};
  return true;
}

/// Until when a place is closed that is closed then; zero where it is open.
core::Seconds closed_until(const std::vector<TimeSpan>& closures, core::Seconds when) {
  const auto holds = [&](const TimeSpan& span) { return span.from <= when && when <= span.until; };
  const auto closure = std::ranges::find_if(closures, holds);
  return closure == closures.end() ? core::Seconds{0.0} : closure->until;
}

/// What closes a place then, zone or iceberg: of both the one that does so for longer; empty where it is open.
std::optional<cost::RouteClosed> closed_place(const cost::Sea& sea, geo::PlanePoint place,
                                              core::Seconds when) {
  const core::Seconds by_zones = closed_until(sea.closed_times_by_zones(place), when);
  const core::Seconds by_icebergs = closed_until(sea.closed_times_by_icebergs(place), when);
  if (by_zones <= when && by_icebergs <= when) return std::nullopt;
  const auto reason = by_zones > by_icebergs ? motion::EdgeClosed::in_zone : motion::EdgeClosed::obstacle;
  return cost::RouteClosed{.reason = reason, .at = place, .when = when};
}

/// What keeps the goal when the vehicle could be there, as if nothing closed and opened in time. Empty where that is
/// open then, and where something of another kind closes the way before it.
std::optional<cost::RouteClosed> closed_goal(const cost::Sea& sea, geo::PlanePoint goal,
                                             const AtOnce& at_once, core::Seconds depart) {
  const auto on_the_way = cost::closed_at_once(sea, at_once.path, depart);
  if (!on_the_way) return std::nullopt;
  const auto closures = on_the_way->reason == motion::EdgeClosed::in_zone
                            ? sea.closed_times_by_zones(goal)
                            : sea.closed_times_by_icebergs(goal);
  if (closed_until(closures, at_once.arrival) <= at_once.arrival) return std::nullopt;
  return closed_place(sea, goal, at_once.arrival);
}

/// The goal's opening, if it opens later: no way was found that is there then, because labels ran out or nothing but
/// circling would do.
std::optional<OpensLater> goal_opens_later(const cost::Sea& sea, const OpenGrid& open, const AtOnce& at_once,
                                           core::Seconds depart) {
  const geo::PlanePoint goal = open.grid.point(open.grid.goal);
  const auto opens = opens_at(sea, goal, at_once.arrival);
  const auto closed = opens ? closed_goal(sea, goal, at_once, depart) : std::nullopt;
  if (!closed) return std::nullopt;
  return OpensLater{*closed, *opens - at_once.arrival};
}

/// Whether the goal opens too late for any way there that may be flown; the result then says so.
bool is_refused_for_late_goal(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open,
                              const AtOnce& at_once, core::Seconds depart) {
  const geo::PlanePoint goal = open.grid.point(open.grid.goal);
  const auto circling = end_opens_too_late(sea, goal, depart, at_once.arrival);
  const auto closed = circling ? closed_goal(sea, goal, at_once, depart) : std::nullopt;
  if (!closed) return false;
  result.opens_later = OpensLater{*closed, *circling, opens_at(sea, goal, at_once.arrival)};
  result.path.clear();
  return true;
}

/// Replaces the way by one that arrives before `latest` although it arrives later somewhere, if there is one.
/// `at_once`: the best way as if nothing closed and opened in time.
/// Returns  whether it did
bool look_for_later_ways(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open,
                         const AtOnce& at_once, core::Seconds depart, core::Seconds latest,
                         const std::stop_token& stop) {
  const core::Seconds least =
      sea.least_time(open.grid.point(open.grid.start), open.grid.point(open.grid.goal));
  const core::Seconds slack = least_gain * (std::isfinite(latest.count()) ? latest - depart : least);
  LaterWay later =
      search_later_ways(sea, open, depart, latest, slack,
                        result.path.empty() ? most_labels_for_a_way : most_labels_for_a_better_way, stop);
  result.statistics.expansions += later.counters.expansions;
  result.statistics.edge_evaluations += later.counters.edge_evaluations;
  result.cancelled = later.cancelled;
  result.statistics.cut_short = later.cut_short;
  const bool comes_later =
      !later.path.empty() && !is_refused_for_circling(result, sea, open, later.path, at_once, depart, stop);
  if (comes_later) {
    result.path = std::move(later.path);
    result.arrival = later.arrival;
  }
  if (later.cut_short && !result.path.empty())
    result.statistics.possible_gain = std::max(core::Seconds{0.0}, result.arrival - later.none_before);
  return comes_later;
}

/// Replaces the way by one that waits, or turns in circles, at one place and arrives within a span, if there is one.
/// `at_once`: as above
/// Returns  whether it did
bool look_for_a_wait(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open, const AtOnce& at_once,
                     core::Seconds depart, ArrivalSpan within, const std::stop_token& stop) {
  const auto end = sea.currents() ? sea.currents()->end() : std::nullopt;
  // A vehicle that circles for as long as may be, and takes twice as long under way as the best way does.
  const core::Seconds most = at_once.arrival + 2.0 * (at_once.arrival - depart);
  const core::Seconds last = std::min({within.before, most, end.value_or(most)});
  WaitingWay waiting =
      search_way_with_one_wait(sea, open, depart, {.after = within.after, .before = last}, stop);
  result.statistics.expansions += waiting.counters.expansions;
  result.statistics.edge_evaluations += waiting.counters.edge_evaluations;
  result.cancelled = waiting.cancelled;
  if (waiting.path.empty() || waiting.arrival >= within.before ||
      is_refused_for_circling(result, sea, open, waiting.path, at_once, depart, stop))
    return false;
  result.path = std::move(waiting.path);
  result.arrival = waiting.arrival;
  return true;
}

/// Whether some leg that the current closed may open later, and a vehicle that holds until then may still reach the goal
/// before `arrival`.
bool may_open_in_time(const RefusedEdges& refused, const StraightBound& straight, core::Seconds arrival) {
  return std::ranges::any_of(refused.edges, [&](const RefusedEdge& leg) {
    return leg.when + straight.least_time(leg.edge) + straight.remaining(leg.edge.head) < arrival;
  });
}

/// Replaces the way by one that holds where that arrives earlier. The way of `result` arrives by `untimed` with the
/// holds that it needs.
/// Returns  whether there is any way then
bool look_for_holds(RouteSearch& result, const cost::Sea& sea, const OpenGrid& open,
                    const UntimedWay& untimed, core::Seconds depart, core::Seconds latest,
                    const std::stop_token& stop, const graph::ExpansionCallback& report) {
  result.arrival = core::Seconds{untimed.arrival_s};
  HeldWay held = search_held_way(sea, open, depart, std::min(latest, result.arrival), stop, report);
  result.statistics.expansions += held.counters.expansions;
  result.statistics.edge_evaluations += held.counters.edge_evaluations;
  result.statistics.cut_short = held.full;
  result.cancelled = held.cancelled;
  if (held.arrival < result.arrival) {
    result.path = std::move(held.path);
    result.arrival = held.arrival;
  }
  return result.cancelled || std::isfinite(result.arrival.count());
}

/// The search as if the time without surfacing were not bounded.
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
    report_fraction(static_cast<double>(expansions) /
                    static_cast<double>(std::max<std::int64_t>(1, result.statistics.vertices)));
  };
  // The same answer as from a search with the straight bound alone, found among fewer vertices.
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
        // With a latest arrival given nobody asks for what opens later.
        const bool may_open_later =
            std::isinf(query.latest.count()) &&
            std::ranges::any_of(refused.edges, [&](const RefusedEdge& leg) {
              return leg.when + straight.least_time(leg.edge) <= bound.latest_use(leg.edge.head);
            });
        if (tree.stopped || (tree.is_reached(grid.goal) && !may_open_later)) {
          refused.edges.clear();  // whenever they open, who waits for it is not at the goal in time
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

  // What no timed closure meets on the best way without any is the best way with all of them.
  const bool in_time = sea.has_timed_closures() && request.method != Method::frozen;
  graph::SearchTree tree = in_time ? search(UntimedTravelTime{sea, grid, &refused}, false)
                                   : search(GridTravelTime{sea, grid, &refused}, false);
  adopt(tree);
  const auto untimed_way = in_time ? timed_without_delay(sea, result.path, depart, tree.arrival_s(grid.goal))
                                   : UntimedWay{.is_best = true, .arrival_s = tree.arrival_s(grid.goal)};
  if (cost::waits_may_help(sea) && request.method != Method::frozen && !result.cancelled) {
    const bool is_hindered =
        (!result.path.empty() && !untimed_way.is_best) || may_open_in_time(refused, straight, result.arrival);
    if (is_hindered) {
      if (look_for_holds(result, sea, open, untimed_way, depart, latest, stop, report)) return result;
      RouteSearch moving = search_unbounded(sea.without_waits(), open, request, depart, stop, report_fraction,
                                            latest, kept_foresight);
      add_work(moving.statistics, result.statistics);
      moving.statistics.cut_short = moving.statistics.cut_short || result.statistics.cut_short;
      return moving;
    }
    if (!result.path.empty()) return result;
  }
  if (in_time && !result.path.empty() && !untimed_way.is_best) {
    const double least_s = tree.arrival_s(grid.goal);
    const AtOnce at_once{result.path, core::Seconds{least_s}};
    if (is_refused_for_late_goal(result, sea, open, at_once, depart)) return result;
    refused.edges.clear();
    tree = search(GridTravelTime{sea, grid, &refused}, true);
    adopt(tree);
    double arrival_s = tree.arrival_s(grid.goal);
    if (untimed_way.arrival_s < arrival_s) {
      arrival_s = untimed_way.arrival_s;
      result.path = at_once.path;
      result.arrival = core::Seconds{arrival_s};
    }
    const auto goal_opens = opens_at(sea, grid.point(grid.goal), at_once.arrival);
    const double soonest_s = goal_opens ? goal_opens->count() : least_s;
    const auto may_gain = [&] {
      return !result.cancelled &&
             (result.path.empty() || arrival_s - soonest_s > least_gain * (arrival_s - depart.count()));
    };
    // A vehicle hardly ever circles where there is a way at once.
    const bool is_likely = result.path.empty();
    bool comes_later = is_likely && may_gain() &&
                       look_for_a_wait(result, sea, open, at_once, depart,
                                       {core::Seconds{soonest_s}, core::Seconds{arrival_s}}, stop);
    if (comes_later) arrival_s = result.arrival.count();
    if (may_gain()) {
      const double worthwhile_s =
          result.path.empty() ? arrival_s : arrival_s - least_gain * (arrival_s - depart.count());
      if (look_for_later_ways(result, sea, open, at_once, depart, core::Seconds{worthwhile_s}, stop))
        comes_later = true;
    }
    const auto gain = result.statistics.possible_gain;
    if (!is_likely && gain && *gain > worth_a_wait * (result.arrival - depart) && !result.cancelled) {
      const core::Seconds before = result.arrival;
      if (look_for_a_wait(result, sea, open, at_once, depart, {core::Seconds{soonest_s}, before}, stop)) {
        comes_later = true;
        result.statistics.possible_gain = std::max(core::Seconds{0.0}, *gain - (before - result.arrival));
      }
    }
    if (!comes_later && is_refused_for_circling(result, sea, open, result.path, at_once, depart, stop))
      result.path.clear();
    if (result.path.empty() && !result.cancelled && !result.opens_later)
      result.opens_later = goal_opens_later(sea, open, at_once, depart);
  }
  // With weights fixed at departure nothing opens later.
  const bool look = std::isinf(latest.count()) && request.method != Method::frozen;
  if (look && !result.cancelled) {
    const auto openings = find_late_openings(sea, request.depart, open, tree, refused, straight, stop);
    result.statistics.fifo_violations = static_cast<std::int64_t>(openings.size());
    for (const LateOpening& opening : openings) {
      result.statistics.worst_fifo_violation = worse_of(result.statistics.worst_fifo_violation, opening);
    }
  }
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
  if (!sea.overhead().bounds_surfacing() || found.cancelled || found.path.empty()) return found;
  // The best way of all is the best of those that keep the bound, if it does.
  const auto since = cost::since_surfacing_at_end(sea, found.path, depart, since_surfacing, found.arrival);
  if (since && *since + open.needed_after_goal() <= *sea.overhead().longest_without_surfacing()) {
    found.since_surfacing = *since;
    return found;
  }
  const auto along_best = cost::arrivals_along(sea, found.path, depart, since_surfacing);
  RouteSearch bounded = search_with_surfacings(sea, open, depart, since_surfacing, stop, report_fraction);
  add_work(bounded.statistics, found.statistics);
  if (const auto circling = circles_too_long(sea, open, bounded.path, depart, found.arrival, stop);
      circling && !along_best) {
    bounded.opens_later = OpensLater{along_best.error(), *circling};
    bounded.path.clear();
  }
  return bounded;
}

}  // namespace floeplan::planning::search

#pragma once

#include <concepts>
#include <stop_token>
#include <vector>

#include "engine/graph/arrival_queue.hpp"
#include "engine/graph/edge_travel_time.hpp"
#include "engine/graph/search_tree.hpp"
#include "engine/graph/tve_search.hpp"

namespace floeplan::graph {

/// Bounds of travel times that are known before the search.
/// Law (admissible)  least_time(edge, depart) never exceeds the time of that edge for a departure from its
/// tail at `depart`
/// Law (consistent)  remaining(tail) <= least_time(edge, depart) + remaining(head); remaining(goal) = 0
/// Law (latest)      a vehicle at v after latest_use(v) cannot be at the goal by the query's latest arrival
template <class B>
concept TravelTimeBound = requires(const B& bound, const Edge& edge, core::Seconds depart, Vertex v) {
  { bound.least_time(edge, depart) } -> std::convertible_to<core::Seconds>;
  { bound.remaining(v) } -> std::convertible_to<core::Seconds>;
  { bound.latest_use(v) } -> std::convertible_to<core::Seconds>;
};

/// No bound: the search becomes Dijkstra's on arrival times.
struct NoBound {
  [[nodiscard]] static core::Seconds least_time(const Edge&, core::Seconds) { return core::Seconds{0.0}; }
  [[nodiscard]] static core::Seconds remaining(Vertex) { return core::Seconds{0.0}; }
  [[nodiscard]] static core::Seconds latest_use(Vertex) { return core::Seconds{SearchTree::never}; }
};

/// Earliest arrivals, with each vertex expanded once: Dijkstra on arrival times, or A* with a bound. Exact
/// under FIFO. An edge is not evaluated if even its least time cannot improve its head, or if the goal cannot
/// be reached from its head by `query.latest`. A vertex reached too late for that does not count as reached.
/// Returns  arrival and predecessor of every vertex expanded before the goal, and of the goal if it can be
///          reached
/// Source   Dreyfus 1969, An appraisal of some shortest-path algorithms, Operations Research 17
///          (time-dependent case); Hart, Nilsson and Raphael 1968, doi:10.1109/TSSC.1968.300136 (A*)
/// Stops    early, and says so in the result, once `stop` is requested
template <EdgeTravelTime TravelTime, TravelTimeBound Bound = NoBound>
SearchTree find_earliest_arrivals(const GridGraph& graph, const Query& query, const TravelTime& travel_time,
                                  const std::stop_token& stop, const Bound& bound = {},
                                  const ExpansionCallback& report = {}) {
  SearchTree tree{graph.size()};
  ArrivalQueue queue{graph.size()};
  std::vector<bool> settled(graph.size(), false);
  if (!graph.is_open(query.source)) return tree;

  const auto remaining_s = [&](Vertex v) { return core::Seconds{bound.remaining(v)}.count(); };
  const bool bounded = query.latest.count() < SearchTree::never;
  tree.start(query.source, query.depart.count());
  queue.insert(query.source, query.depart.count() + remaining_s(query.source));
  while (!queue.empty() && queue.smallest_key() <= query.latest.count()) {
    if (is_to_stop(tree, stop, report)) break;
    const Vertex u = queue.extract_min();
    settled[u] = true;
    ++tree.counters.expansions;
    if (query.goal && u == *query.goal) break;

    const double arrival_u = tree.arrival_s(u);
    graph.for_each_edge(u, [&](const Edge& edge) {
      const double least_s =
          arrival_u + core::Seconds{bound.least_time(edge, core::Seconds{arrival_u})}.count();
      if (least_s >= tree.arrival_s(edge.head)) return;
      if (settled[edge.head]) return;
      if (bounded && least_s + remaining_s(edge.head) > query.latest.count()) return;
      const double latest_use_s = core::Seconds{bound.latest_use(edge.head)}.count();
      if (least_s > latest_use_s) return;
      ++tree.counters.edge_evaluations;
      const auto duration =
          travel_time(edge, core::Seconds{arrival_u}, core::Seconds{tree.arrival_s(edge.head)});
      if (!duration) return;
      const double arrival_v = arrival_u + core::Seconds{*duration}.count();
      if (!(arrival_v < tree.arrival_s(edge.head)) || arrival_v > latest_use_s) return;

      tree.reach(edge, arrival_v);
      const double key = arrival_v + remaining_s(edge.head);
      if (queue.holds(edge.head)) {
        queue.decrease_key(edge.head, key);
      } else {
        queue.insert(edge.head, key);
      }
    });
  }
  return tree;
}

}  // namespace floeplan::graph

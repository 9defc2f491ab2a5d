#pragma once

#include <stop_token>

#include "engine/graph/arrival_queue.hpp"
#include "engine/graph/edge_travel_time.hpp"
#include "engine/graph/search_tree.hpp"

namespace floeplan::graph {

/// Earliest arrivals in a time-varying environment; label-correcting, exact under FIFO. Runs until the queue
/// is empty, as in the paper: a goal or a latest arrival in the query does not end it early.
/// Returns  arrival and predecessor of every reachable vertex, counters of the search
/// Source   Eichhorn 2009, Table I, right column; d: arrival, pi: predecessor, t_0: query.depart. A vertex is
///          GRAY while it is in the queue. The paper sets pi <- infinity at the start; here a vertex has no
///          predecessor
/// Stops    early, and says so in the result, once `stop` is requested
template <EdgeTravelTime TravelTime>
SearchTree find_earliest_arrivals_tve(const GridGraph& graph, const Query& query,
                                      const TravelTime& travel_time, const std::stop_token& stop,
                                      const ExpansionCallback& report = {}) {
  SearchTree tree{graph.size()};
  ArrivalQueue queue{graph.size()};
  std::vector<bool> expanded(graph.size(), false);
  if (!graph.is_open(query.source)) return tree;

  tree.start(query.source, query.depart.count());
  queue.insert(query.source, query.depart.count());
  while (!queue.empty()) {
    if (is_to_stop(tree, stop, report)) break;
    const Vertex u = queue.extract_min();
    expanded[u] = true;
    ++tree.counters.expansions;

    const double arrival_u = tree.arrival_s(u);
    graph.for_each_edge(u, [&](const Edge& edge) {
      ++tree.counters.edge_evaluations;
      const auto duration =
          travel_time(edge, core::Seconds{arrival_u}, core::Seconds{tree.arrival_s(edge.head)});
      if (!duration) return;
      const double arrival_v = core::Seconds{*duration}.count() + arrival_u;
      if (!(arrival_v < tree.arrival_s(edge.head))) return;

      tree.reach(edge, arrival_v);
      if (queue.holds(edge.head)) {
        queue.decrease_key(edge.head, arrival_v);
      } else {
        if (expanded[edge.head]) ++tree.counters.reinsertions;
        queue.insert(edge.head, arrival_v);
      }
    });
  }
  return tree;
}

}  // namespace floeplan::graph

#pragma once

#include <optional>
#include <stop_token>

#include "engine/graph/arrival_queue.hpp"
#include "engine/graph/edge_travel_time.hpp"
#include "engine/graph/search_tree.hpp"
#include "engine/graph/tve_search.hpp"

namespace floeplan::graph {

/// Result of a search for the nearest of many goals.
struct NearestGoal {
  SearchTree tree;
  std::optional<Vertex> goal;  // the goal reached first; empty: none by `latest`
};

/// The goal that is reached first from a vertex. Whether a vertex is a goal may depend on the arrival:
/// `is_goal(v, arrival)`. Exact under FIFO for goals that stay goals. Arrivals after `latest` are of no use.
/// Stops    early, and says so in the tree, once `stop` is requested
/// Source   Dijkstra's search on arrival times, ended at the first settled goal (Dreyfus 1969, see
///          time_dependent_astar.hpp)
template <EdgeTravelTime TravelTime, class IsGoal>
NearestGoal find_nearest_goal(const GridGraph& graph, Vertex source, core::Seconds depart,
                              core::Seconds latest, const TravelTime& travel_time, const IsGoal& is_goal,
                              const std::stop_token& stop) {
  NearestGoal result{SearchTree{graph.size()}, std::nullopt};
  SearchTree& tree = result.tree;
  ArrivalQueue queue{graph.size()};
  if (!graph.is_open(source)) return result;

  tree.start(source, depart.count());
  queue.insert(source, depart.count());
  while (!queue.empty()) {
    if (is_to_stop(tree, stop, {})) break;
    const Vertex u = queue.extract_min();
    ++tree.counters.expansions;
    const core::Seconds arrival_u{tree.arrival_s(u)};
    if (is_goal(u, arrival_u)) {
      result.goal = u;
      break;
    }
    graph.for_each_edge(u, [&](const Edge& edge) {
      ++tree.counters.edge_evaluations;
      const core::Seconds known{tree.arrival_s(edge.head)};
      const auto duration = travel_time(edge, arrival_u, known < latest ? known : latest);
      if (!duration) return;
      const core::Seconds arrival = arrival_u + core::Seconds{*duration};
      if (!(arrival < known) || arrival > latest) return;
      tree.reach(edge, arrival.count());
      if (queue.holds(edge.head)) {
        queue.decrease_key(edge.head, arrival.count());
      } else {
        queue.insert(edge.head, arrival.count());
      }
    });
  }
  return result;
}

}  // namespace floeplan::graph

#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/graph/time_dependent_astar.hpp"

namespace floeplan::graph {

/// The area around the middle of a path that later paths must avoid.
struct CorridorGate {
  int column{};
  int row{};
  double radius{};  // in grid steps

  [[nodiscard]] bool bars(const GridGraph& graph, Vertex v) const {
    return std::hypot(graph.column(v) - column, graph.row(v) - row) < radius;
  }
};

/// Paths through different corridors. Each is the earliest that avoids the middles of the paths before. They
/// are starting points for a search that is not bound to the grid. At most `most`; fewer if there are no
/// more, or once `stop` is requested.
/// Law      the first path is the earliest of all
template <EdgeTravelTime TravelTime>
std::vector<std::vector<Vertex>> find_corridors(const GridGraph& graph, const Query& query,
                                                const TravelTime& travel_time, std::size_t most,
                                                const std::stop_token& stop = {}) {
  constexpr double share_of_way = 1.0 / 8.0;  // of a path: wide enough to separate the next path
  const Vertex goal = query.goal.value();
  const double way =
      std::hypot(graph.column(goal) - graph.column(query.source), graph.row(goal) - graph.row(query.source));

  std::vector<CorridorGate> gates;
  const auto around_gates = [&](const Edge& edge, core::Seconds depart,
                                core::Seconds latest) -> std::optional<core::Seconds> {
    const auto bars_head = [&](const CorridorGate& gate) { return gate.bars(graph, edge.head); };
    if (edge.head != goal && std::ranges::any_of(gates, bars_head)) return std::nullopt;
    const auto time = travel_time(edge, depart, latest);
    return time ? std::optional{core::Seconds{*time}} : std::nullopt;
  };

  std::vector<std::vector<Vertex>> corridors;
  while (corridors.size() < most) {
    const SearchTree tree = find_earliest_arrivals(graph, query, around_gates, stop);
    const std::vector<Vertex> path = path_to(graph, tree, goal);
    if (tree.stopped || path.empty()) break;
    const Vertex middle = path[path.size() / 2];
    gates.push_back({graph.column(middle), graph.row(middle), std::max(1.5, share_of_way * way)});
    corridors.push_back(path);
  }
  return corridors;
}

}  // namespace floeplan::graph

#pragma once

#include <stop_token>
#include <vector>

#include "engine/planning/favourable_grid.hpp"

namespace floeplan::planning {

/// What is known of the times on a grid before any search: what is left to its goal at the best hour of every edge.
/// Worth its making where many departures are searched on one grid.
/// Satisfies  graph::TravelTimeBound
/// Threads    const members may be called from several threads at once
class FavourableBound {
 public:
  /// Both are borrowed and outlive this. Once `stop` is requested it must not be used.
  FavourableBound(const Sea& sea, const OpenGrid& open, const std::stop_token& stop)
      : grid_{sea, open}, to_goal_s_(open.graph.size(), graph::SearchTree::never) {
    to_goal_s_[open.grid.goal] = 0.0;
    lower_times(to_goal_s_, graph::SearchTree::never, stop,
                [&](graph::Vertex v, double time_s, const auto& visit) {
                  grid_.for_each_edge_to(
                      v, [&](const graph::Edge& edge, double edge_s) { visit(edge.tail, time_s + edge_s); });
                });
  }

  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds) const {
    return core::Seconds{grid_.least_s(edge)};
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const { return core::Seconds{to_goal_s_[v]}; }
  [[nodiscard]] static core::Seconds latest_use(graph::Vertex) {
    return core::Seconds{graph::SearchTree::never};
  }

 private:
  FavourableGrid grid_;
  std::vector<double> to_goal_s_;
};

}  // namespace floeplan::planning

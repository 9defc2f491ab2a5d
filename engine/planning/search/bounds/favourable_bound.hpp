#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/graph/search_tree.hpp"
#include "engine/planning/search/bounds/favourable_grid.hpp"

namespace floeplan::planning::search {

/// Lower bounds of travel times on a grid, computed without a time-dependent search: the remaining time to
/// the goal if every edge takes its shortest possible time. They are worth their cost if many departures are
/// searched on one grid.
/// Satisfies  graph::TravelTimeBound, with one difference: `remaining` is consistent with the true times of
///            edges, not with the shorter times of `least_time`
/// Threads    const members may be called from several threads at once
class FavourableBound {
 public:
  /// `sea` and `open` are borrowed and must outlive this object. Once `stop` is requested it must not be
  /// used.
  FavourableBound(const cost::Sea& sea, const OpenGrid& open, const std::stop_token& stop)
      : left_s_(open.graph.size(), graph::SearchTree::never) {
    const FavourableGrid grid{sea, open};  // it is large, so only the results are kept
    left_s_[open.grid.goal] = 0.0;
    lower_times(left_s_, graph::SearchTree::never, stop,
                [&](graph::Vertex v, double time_s, const auto& visit) {
                  grid.for_each_edge_to(
                      v, [&](const graph::Edge& edge, double edge_s) { visit(edge.tail, time_s + edge_s); });
                });
    for (std::size_t step = 0; step < open.graph.offsets().size(); ++step)
      straight_s_.push_back(
          grid.straight_s({open.grid.start, open.grid.start, static_cast<std::uint8_t>(step)}));
  }

  /// Lower bound of the edge's time with the strongest current of the whole area from astern. `remaining`
  /// uses the strongest current near each edge, so it is sharper.
  [[nodiscard]] core::Seconds least_time(const graph::Edge& edge, core::Seconds) const {
    return core::Seconds{straight_s_[edge.step]};
  }
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const { return core::Seconds{left_s_[v]}; }
  [[nodiscard]] static core::Seconds latest_use(graph::Vertex) {
    return core::Seconds{graph::SearchTree::never};
  }

 private:
  std::vector<double> left_s_;
  std::vector<double> straight_s_;  // by step (direction) of the grid
};

}  // namespace floeplan::planning::search

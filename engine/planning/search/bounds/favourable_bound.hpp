#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "engine/graph/search_tree.hpp"
#include "engine/planning/search/bounds/favourable_grid.hpp"

namespace floeplan::planning::search {

/// The end of a grid's route to which a bound counts.
enum class RouteEnd { start, goal };

/// Lower bounds of travel times on a grid, computed without a time-dependent search: the time between a vertex and
/// one end of the route if every edge takes its shortest possible time. They are worth their cost if many
/// departures are searched on one grid.
/// Satisfies  graph::TravelTimeBound, with one difference: `remaining` is consistent with the true times of
///            edges, not with the shorter times of `least_time`
/// Threads    const members may be called from several threads at once
class FavourableBound {
 public:
  /// Only the results are kept. Once `stop` is requested they must not be used.
  FavourableBound(const FavourableGrid& grid, RouteEnd end, const std::stop_token& stop)
      : left_s_(grid.open().graph.size(), graph::SearchTree::never) {
    const OpenGrid& open = grid.open();
    left_s_[end == RouteEnd::goal ? open.grid.goal : open.grid.start] = 0.0;
    lower_times(
        left_s_, graph::SearchTree::never, stop, [&](graph::Vertex v, double time_s, const auto& visit) {
          if (end == RouteEnd::goal) {
            grid.for_each_edge_to(
                v, [&](const graph::Edge& edge, double edge_s) { visit(edge.tail, time_s + edge_s); });
          } else {
            grid.for_each_edge_from(
                v, [&](const graph::Edge& edge, double edge_s) { visit(edge.head, time_s + edge_s); });
          }
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
  /// Lower bound of the time between a vertex and the end.
  [[nodiscard]] core::Seconds remaining(graph::Vertex v) const { return core::Seconds{left_s_[v]}; }
  [[nodiscard]] static core::Seconds latest_use(graph::Vertex) {
    return core::Seconds{graph::SearchTree::never};
  }

 private:
  std::vector<double> left_s_;
  std::vector<double> straight_s_;  // by step (direction) of the grid
};

/// The bounds to both ends of the route.
struct FavourableBounds {
  FavourableBound to_goal;
  FavourableBound from_start;

  /// `sea` and `open` are borrowed during the call. Once `stop` is requested the result must not be used.
  FavourableBounds(const cost::Sea& sea, const OpenGrid& open, const std::stop_token& stop)
      : FavourableBounds{FavourableGrid{sea, open}, stop} {}

 private:
  FavourableBounds(const FavourableGrid& grid, const std::stop_token& stop)
      : to_goal{grid, RouteEnd::goal, stop}, from_start{grid, RouteEnd::start, stop} {}
};

}  // namespace floeplan::planning::search

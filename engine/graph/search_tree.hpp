#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/graph/grid_graph.hpp"

namespace floeplan::graph {

/// Source and goal of a search, and the departure.
struct Query {
  Vertex source{};
  std::optional<Vertex> goal;  // empty: every reachable vertex
  core::Seconds depart{};
  core::Seconds latest{std::numeric_limits<double>::infinity()};  // later arrivals are of no use
};

/// Counts of the work of a search.
struct SearchCounters {
  std::int64_t edge_evaluations{};
  std::int64_t expansions{};
  std::int64_t reinsertions{};  // of vertices that were already expanded (BLACK in the paper)
};

/// The earliest arrivals found, and the edge by which each vertex was reached.
class SearchTree {
 public:
  static constexpr double never = std::numeric_limits<double>::infinity();

  explicit SearchTree(std::size_t vertices) : arrival_s_(vertices, never), step_(vertices, no_step) {}

  [[nodiscard]] bool is_reached(Vertex v) const { return arrival_s_[v] < never; }
  /// Earliest arrival at `v`, in seconds; infinite if `v` was not reached.
  [[nodiscard]] double arrival_s(Vertex v) const { return arrival_s_[v]; }
  [[nodiscard]] bool has_predecessor(Vertex v) const { return step_[v] != no_step; }
  /// Index of the step that reached `v`. Valid only if `has_predecessor(v)`.
  [[nodiscard]] std::uint8_t step(Vertex v) const { return step_[v]; }

  void start(Vertex source, double depart_s) { arrival_s_[source] = depart_s; }
  void reach(const Edge& edge, double arrival_s) {
    arrival_s_[edge.head] = arrival_s;
    step_[edge.head] = edge.step;
  }

  SearchCounters counters;
  bool stopped{false};  // stopped by the caller: the result is incomplete

 private:
  static constexpr std::uint8_t no_step = 255;

  std::vector<double> arrival_s_;
  std::vector<std::uint8_t> step_;
};

/// The vertices from the source to `goal`, both included; empty if the goal was not reached.
[[nodiscard]] std::vector<Vertex> path_to(const GridGraph& graph, const SearchTree& tree, Vertex goal);

/// Called after every 1024 expansions with their total number.
using ExpansionCallback = std::function<void(std::int64_t expansions)>;

/// Expansions between two checks of the stop token: few enough to react within 100 ms, enough to cost no
/// time.
inline constexpr std::int64_t expansions_between_looks = 64;
inline constexpr std::int64_t expansions_between_reports = 1024;

/// Call before each expansion: checks `stop` and reports progress from time to time.
/// Returns  whether the search must end; the tree is then marked as stopped
[[nodiscard]] inline bool is_to_stop(SearchTree& tree, const std::stop_token& stop,
                                     const ExpansionCallback& report) {
  const std::int64_t expansions = tree.counters.expansions;
  if (expansions % expansions_between_looks != 0) return false;
  tree.stopped = stop.stop_requested();
  if (!tree.stopped && report && expansions % expansions_between_reports == 0) report(expansions);
  return tree.stopped;
}

}  // namespace floeplan::graph

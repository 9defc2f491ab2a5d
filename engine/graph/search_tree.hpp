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

/// The start and the goal of a search, and its departure.
struct Query {
  Vertex source{};
  std::optional<Vertex> goal;  // empty: to every vertex that can be reached
  core::Seconds depart{};
  core::Seconds latest{std::numeric_limits<double>::infinity()};  // arrivals after it are of no use
};

/// What a search did.
struct SearchCounters {
  std::int64_t edge_evaluations{};
  std::int64_t expansions{};
  std::int64_t reinsertions{};  // of vertices that had already been expanded (BLACK in the paper)
};

/// Earliest arrivals found, and how each vertex was reached.
class SearchTree {
 public:
  static constexpr double never = std::numeric_limits<double>::infinity();

  explicit SearchTree(std::size_t vertices) : arrival_s_(vertices, never), step_(vertices, no_step) {}

  [[nodiscard]] bool is_reached(Vertex v) const { return arrival_s_[v] < never; }
  /// Infinite when not reached.
  [[nodiscard]] double arrival_s(Vertex v) const { return arrival_s_[v]; }
  [[nodiscard]] bool has_predecessor(Vertex v) const { return step_[v] != no_step; }
  /// The step of the edge that reached `v`. Defined only where `has_predecessor(v)`.
  [[nodiscard]] std::uint8_t step(Vertex v) const { return step_[v]; }

  void start(Vertex source, double depart_s) { arrival_s_[source] = depart_s; }
  void reach(const Edge& edge, double arrival_s) {
    arrival_s_[edge.head] = arrival_s;
    step_[edge.head] = edge.step;
  }

  SearchCounters counters;
  bool stopped{false};  // the caller asked for it: what is here is not complete

 private:
  static constexpr std::uint8_t no_step = 255;

  std::vector<double> arrival_s_;
  std::vector<std::uint8_t> step_;
};

/// The vertices from the source to `goal`, both included; empty when the goal was not reached.
[[nodiscard]] std::vector<Vertex> path_to(const GridGraph& graph, const SearchTree& tree, Vertex goal);

/// Called with the number of expansions after every 1024 of them.
using ExpansionCallback = std::function<void(std::int64_t expansions)>;

/// How often a search looks at its stop token and reports: often enough for 100 ms, seldom enough to cost
/// nothing.
inline constexpr std::int64_t expansions_between_looks = 64;
inline constexpr std::int64_t expansions_between_reports = 1024;

/// To be asked before each expansion: looks at `stop` now and then, and reports.
/// Returns  whether the search has to end; the tree then says that it was stopped
[[nodiscard]] inline bool is_to_stop(SearchTree& tree, const std::stop_token& stop,
                                     const ExpansionCallback& report) {
  const std::int64_t expansions = tree.counters.expansions;
  if (expansions % expansions_between_looks != 0) return false;
  tree.stopped = stop.stop_requested();
  if (!tree.stopped && report && expansions % expansions_between_reports == 0) report(expansions);
  return tree.stopped;
}

}  // namespace floeplan::graph

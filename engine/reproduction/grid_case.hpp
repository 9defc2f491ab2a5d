#pragma once

#include <cstdint>
#include <vector>

#include "engine/graph/grid_graph.hpp"
#include "engine/reproduction/obstacle.hpp"

namespace floeplan::reproduction {

/// A vertex by its column and row.
struct Node {
  int column{};
  int row{};
};

/// The rectangle of water of a case, with its grid, start and goal.
struct CaseGrid {
  geo::PlanePoint low;
  double dx{};
  double dy{};
  int nx{};
  int ny{};
  Node start;
  Node goal;

  [[nodiscard]] geo::PlanePoint point(Node node) const {
    return {low.x_m + dx * node.column, low.y_m + dy * node.row};
  }
  [[nodiscard]] geo::PlanePoint high() const { return point({nx - 1, ny - 1}); }
};

/// The input of a search: grid structure, obstacles, and edge weights.
struct GridCase {
  CaseGrid grid;
  int sectors{1};
  std::vector<Obstacle> obstacles{};
  bool frozen{false};  // every edge keeps its weight of the departure: left column of the paper's Table I

  /// The grid graph; vertices inside an obstacle are closed.
  [[nodiscard]] graph::GridGraph graph() const;
  [[nodiscard]] bool is_open(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Number of directed edges between open vertices that meet no obstacle.
  [[nodiscard]] std::int64_t count_open_edges() const;
};

}  // namespace floeplan::reproduction

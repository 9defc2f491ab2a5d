#include "engine/reproduction/grid_case.hpp"

#include <algorithm>

namespace floeplan::reproduction {

graph::GridGraph GridCase::graph() const {
  std::vector<std::uint8_t> open;
  for (int row = 0; row < grid.ny; ++row) {
    for (int column = 0; column < grid.nx; ++column) {
      const geo::PlanePoint point = grid.point({column, row});
      open.push_back(is_open(point, point) ? 1 : 0);
    }
  }
  return graph::GridGraph{grid.nx, grid.ny, sectors, std::move(open)};
}

bool GridCase::is_open(geo::PlanePoint a, geo::PlanePoint b) const {
  return std::ranges::none_of(obstacles, [&](const Obstacle& obstacle) { return obstacle.meets(a, b); });
}

std::int64_t GridCase::count_open_edges() const {
  const graph::GridGraph vertices = graph();
  const auto point = [&](graph::Vertex v) { return grid.point({vertices.column(v), vertices.row(v)}); };
  std::int64_t count = 0;
  for (graph::Vertex v = 0; v < vertices.size(); ++v) {
    if (!vertices.is_open(v)) continue;
    vertices.for_each_edge(v, [&](const graph::Edge& edge) {
      if (is_open(point(edge.tail), point(edge.head))) ++count;
    });
  }
  return count;
}

}  // namespace floeplan::reproduction

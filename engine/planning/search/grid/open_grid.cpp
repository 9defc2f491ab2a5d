#include "engine/planning/search/grid/open_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace floeplan::planning::search {
namespace {

using graph::Edge;
using graph::Vertex;

constexpr Vertex vertices_between_looks =
    256;  // vertices between two checks of the stop token; some milliseconds among icebergs

std::vector<std::uint8_t> open_vertices(const cost::PlanningDomain& domain, const cost::RouteGrid& grid,
                                        const std::stop_token& stop) {
  std::vector<std::uint8_t> open(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
  for (Vertex v = 0; v < open.size(); ++v) {
    if (v % vertices_between_looks == 0 && stop.stop_requested()) break;
    const geo::PlanePoint point = grid.point(v);
    open[v] = domain.closures().closed_between(point, point) ? 0 : 1;
  }
  return open;
}

std::int64_t count_open_edges(const cost::PlanningDomain& domain, const cost::RouteGrid& grid,
                              const graph::GridGraph& graph, const std::stop_token& stop) {
  const core::Metres reach = reach_of(grid, graph);
  std::int64_t count = 0;
  for (Vertex v = 0; v < graph.size(); ++v) {
    if (v % vertices_between_looks == 0 && stop.stop_requested()) break;
    if (!graph.is_open(v)) continue;
    const bool all_open = domain.closures().open_about(grid.point(v), reach);
    graph.for_each_edge(v, [&](const Edge& edge) {
      if (all_open || !domain.closures().closed_between(grid.point(edge.tail), grid.point(edge.head)))
        ++count;
    });
  }
  return count;
}

}  // namespace

core::Metres reach_of(const cost::RouteGrid& grid, const graph::GridGraph& graph) {
  double furthest = 0.0;
  for (const graph::Offset offset : graph.offsets()) {
    const double x_m = offset.dx * grid.along.x_m + offset.dy * grid.across.x_m;
    const double y_m = offset.dx * grid.along.y_m + offset.dy * grid.across.y_m;
    furthest = std::max({furthest, std::abs(x_m), std::abs(y_m)});
  }
  return core::Metres{furthest};
}

OpenGrid open_grid(const cost::PlanningDomain& domain, const cost::RouteGrid& grid, int sectors,
                   const std::stop_token& stop) {
  graph::GridGraph graph{grid.nx, grid.ny, sectors, open_vertices(domain, grid, stop)};
  const std::int64_t vertices = graph.count_open_vertices();
  const std::int64_t edges = count_open_edges(domain, grid, graph, stop);
  return {.grid = grid, .graph = std::move(graph), .vertices = vertices, .edges = edges};
}

}  // namespace floeplan::planning::search

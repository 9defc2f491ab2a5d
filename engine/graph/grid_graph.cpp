#include "engine/graph/grid_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace floeplan::graph {

std::vector<Offset> sector_offsets(int sectors) {
  if (sectors < 1 || sectors > 5) throw std::invalid_argument{"a grid has 1 to 5 sectors"};
  std::vector<Offset> offsets;
  for (int dy = -sectors; dy <= sectors; ++dy) {
    for (int dx = -sectors; dx <= sectors; ++dx) {
      if (std::gcd(dx, dy) == 1) offsets.push_back({dx, dy});
    }
  }
  const auto angle = [](Offset o) {
    const double turned = std::atan2(o.dy, o.dx);
    return turned < 0.0 ? turned + 7.0
                        : turned;  // 7 > 2 pi: the lower half is sorted behind the upper half, in its order
  };
  std::ranges::sort(offsets, [&](Offset a, Offset b) { return angle(a) < angle(b); });
  return offsets;
}

GridGraph::GridGraph(int nx, int ny, int sectors, std::vector<std::uint8_t> open)
    : nx_{nx}, ny_{ny}, reach_{sectors}, offsets_{sector_offsets(sectors)}, open_{std::move(open)} {
  if (nx < 1 || ny < 1 || std::int64_t{nx} * ny > std::numeric_limits<std::int32_t>::max()) {
    throw std::invalid_argument{"a grid needs at least one vertex and at most 2^31"};
  }
  if (!open_.empty() && open_.size() != size()) {
    throw std::invalid_argument{"a grid needs one open flag for each vertex"};
  }
  for (const Offset o : offsets_) strides_.push_back(static_cast<Vertex>(o.dy * nx_ + o.dx));
}

GridGraph GridGraph::keeping(const std::vector<bool>& kept) const {
  GridGraph graph = *this;
  graph.open_.resize(size());
  for (Vertex v = 0; v < size(); ++v) graph.open_[v] = is_open(v) && kept[v] ? 1 : 0;
  return graph;
}

std::int64_t GridGraph::count_open_vertices() const {
  if (open_.empty()) return static_cast<std::int64_t>(size());
  return std::ranges::count_if(open_, [](std::uint8_t flag) { return flag != 0; });
}

std::int64_t GridGraph::count_edges() const {
  std::int64_t count = 0;
  if (open_.empty()) {
    for (const Offset o : offsets_) {
      count += std::int64_t{std::max(0, nx_ - std::abs(o.dx))} * std::max(0, ny_ - std::abs(o.dy));
    }
    return count;
  }
  for (Vertex v = 0; v < size(); ++v) {
    if (is_open(v)) for_each_edge(v, [&](const Edge&) { ++count; });
  }
  return count;
}

}  // namespace floeplan::graph

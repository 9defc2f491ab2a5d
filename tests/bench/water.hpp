#pragma once

#include <cstddef>
#include <vector>

namespace floeplan::bench {

/// A current for the measurements of the search alone: a coarse grid over a square of vertices, bilinear in
/// place and linear in time, one pair of floats for each node and slice.
/// Shape  [slice][row][column], last index fastest
struct Water {
  static constexpr int nodes = 126;  // on each side: a cell spans eight of a thousand vertices
  static constexpr int slices = 300;
  static constexpr float slice_s = 10'800.0F;

  struct Node {
    float x_m_s;
    float y_m_s;
  };

  float cells_per_vertex{};
  std::vector<Node> currents;

  /// Creates drifting eddies of up to 0.15 m/s, on `vertices` x `vertices` vertices.
  explicit Water(int vertices);

  [[nodiscard]] const Node& at(int slice, int row, int column) const {
    return currents[(static_cast<std::size_t>(slice) * nodes + static_cast<std::size_t>(row)) * nodes +
                    static_cast<std::size_t>(column)];
  }
};

}  // namespace floeplan::bench

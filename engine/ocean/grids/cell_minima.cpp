#include "engine/ocean/grids/cell_minima.hpp"

#include <algorithm>
#include <limits>

#include "engine/ocean/grids/node_box.hpp"

namespace floeplan::ocean {
namespace {

constexpr float unknown = std::numeric_limits<float>::infinity();

float least_corner(const Mesh::Cell& cell, std::span<const float> values) {
  float least = unknown;
  for (const std::uint32_t corner : cell)
    if (values[corner] < least) least = values[corner];  // a missing one compares as false
  return least;
}

}  // namespace

std::vector<float> least_of_cells(const Mesh& mesh, const HorizontalGrid& grid,
                                  std::span<const float> values) {
  std::vector<float> least(grid.size(), unknown);
  const NodeBoxes boxes{grid, mesh};
  const std::size_t columns = grid.x().size();
  for (const Mesh::Cell& cell : mesh.cells) {
    const float here = least_corner(cell, values);
    if (here == unknown) continue;
    const NodeBox box = boxes.near_or_beside(cell);
    for (std::size_t iy = box.first_y; iy < box.first_y + box.count_y; ++iy)
      for (std::size_t i = 0; i < box.count_x; ++i) {
        float& node = least[iy * columns + (box.first_x + i) % columns];
        node = std::min(node, here);
      }
  }
  std::ranges::replace(least, unknown, std::numeric_limits<float>::quiet_NaN());
  return least;
}

}  // namespace floeplan::ocean

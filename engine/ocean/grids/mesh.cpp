#include "engine/ocean/grids/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geo/tangent_plane.hpp"

namespace floeplan::ocean {
namespace {

constexpr std::size_t max_sampled_cells = 20'000;  // enough for a quantile

}  // namespace

double longest_side_m(const Mesh& mesh, const Mesh::Cell& cell) {
  double longest = 0.0;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const double side =
        geo::sphere_distance_m(mesh.points[cell[i]], mesh.points[cell[(i + 1) % cell.size()]]);
    if (std::isnan(side)) return side;
    longest = std::max(longest, side);
  }
  return longest;
}

double quantile_of_sides_m(const Mesh& mesh, double share) {
  const std::size_t step = std::max<std::size_t>(1, mesh.cells.size() / max_sampled_cells);
  std::vector<double> sides;
  for (std::size_t i = 0; i < mesh.cells.size(); i += step) {
    const double side = longest_side_m(mesh, mesh.cells[i]);
    if (side > 0.0) sides.push_back(side);
  }
  if (sides.empty()) return 0.0;
  const auto at = sides.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sides.size() - 1));
  std::nth_element(sides.begin(), at, sides.end());
  return *at;
}

std::size_t points_with_values(const Mesh& mesh) {
  if (!mesh.in_faces) return mesh.points.size();
  std::vector<bool> is_middle(mesh.points.size());
  for (const Mesh::Cell& cell : mesh.cells) is_middle[cell[0]] = true;
  return static_cast<std::size_t>(std::ranges::count(is_middle, true));
}

void fill_nodes_from_faces(const Mesh& mesh, std::vector<float>& values) {
  // In the mesh each side of a face is one cell. So every node meets a face's middle in two cells, and all
  // faces count equally.
  std::vector<double> sums(values.size(), 0.0);
  std::vector<std::uint32_t> counts(values.size(), 0);
  std::vector<bool> is_middle(values.size());
  for (const Mesh::Cell& cell : mesh.cells) {
    const float value = values[cell[0]];
    is_middle[cell[0]] = true;
    if (std::isnan(value)) continue;
    for (const std::uint32_t node : {cell[1], cell[2]}) {
      sums[node] += static_cast<double>(value);
      ++counts[node];
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_middle[i])
      values[i] =
          counts[i] > 0 ? static_cast<float>(sums[i] / counts[i]) : std::numeric_limits<float>::quiet_NaN();
}

}  // namespace floeplan::ocean

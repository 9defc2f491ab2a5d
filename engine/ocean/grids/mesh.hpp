#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::ocean {

/// A model's own points and the cells between them, within which its values are interpolated.
/// Threads  a value
struct Mesh {
  /// Corners in turn round the cell, as indices of points. A triangle repeats its third corner.
  using Cell = std::array<std::uint32_t, 4>;

  std::vector<geo::LonLat> points;
  std::vector<Cell> cells;
  /// The values are those of faces. Each cell is then the triangle of a face's middle, its first corner, and one side of
  /// the face; the middles carry the model's values, and a node has the mean of the known values in the faces round it.
  bool in_faces{false};
};

/// Length of the sides of the cells that a share of them do not reach, metres. Of many cells some thousands are measured.
/// Outside  0 for a mesh without cells of any extent
[[nodiscard]] double quantile_of_sides_m(const Mesh& mesh, double share);

/// The longest side of a cell, metres; not a number where a corner has no place.
[[nodiscard]] double longest_side_m(const Mesh& mesh, const Mesh::Cell& cell);

/// How many points carry the model's values.
[[nodiscard]] std::size_t points_with_values(const Mesh& mesh);

/// Gives every node the mean of the known values in the faces round it. Precondition: `mesh.in_faces`.
/// Shape  values are [point]; NaN where missing
void fill_nodes_from_faces(const Mesh& mesh, std::vector<float>& values);

}  // namespace floeplan::ocean

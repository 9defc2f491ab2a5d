#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::ocean {

/// A model's own points and the cells between them, within which values are interpolated.
/// Threads  a plain value
struct Mesh {
  /// Corners in order around the cell, as indices into `points`. A triangle repeats its third corner.
  using Cell = std::array<std::uint32_t, 4>;

  std::vector<geo::LonLat> points;
  std::vector<Cell> cells;
  /// True: the model gives values for faces. Each cell is then a triangle: the middle of a face (its first
  /// corner) and one side of the face. The middles carry the model's values. A node has the mean of the known
  /// values in the faces around it.
  bool in_faces{false};
};

/// Quantile of the lengths of cell sides, in metres: `share` of the sides are shorter. Of many cells some
/// thousands are measured.
/// Outside  0 for a mesh without cells of any extent
[[nodiscard]] double quantile_of_sides_m(const Mesh& mesh, double share);

/// The longest side of a cell in metres; NaN if a corner has no place.
[[nodiscard]] double longest_side_m(const Mesh& mesh, const Mesh::Cell& cell);

/// Number of points that carry the model's values.
[[nodiscard]] std::size_t points_with_values(const Mesh& mesh);

/// Gives every node the mean of the known values in the faces around it. Precondition: `mesh.in_faces`.
/// Shape  values are [point]; NaN if missing
void fill_nodes_from_faces(const Mesh& mesh, std::vector<float>& values);

}  // namespace floeplan::ocean

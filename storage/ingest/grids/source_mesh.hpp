#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::ingest {

/// The points of a source and the cells between them, within which the currents are interpolated.
struct SourceMesh {
  /// Corners in turn round the cell, as indices of points. A triangle repeats its third corner.
  using Cell = std::array<std::uint32_t, 4>;

  std::vector<geo::LonLat> points;
  std::vector<Cell> cells;
};

/// The four-sided cells of points that are numbered [row][column]. Points that are not finite, and cells whose sides
/// are far longer than most (across the fold or the seam of a global grid, or to places that a model never filled
/// in), are left out.
[[nodiscard]] SourceMesh mesh_of_rows(std::vector<geo::LonLat> points, std::size_t columns);

/// Length of the sides of the cells that a quarter of them do not reach, metres: the resolution where it is fine.
[[nodiscard]] double fine_spacing_m(const SourceMesh& mesh);

}  // namespace floeplan::ingest

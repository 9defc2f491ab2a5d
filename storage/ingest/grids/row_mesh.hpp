#pragma once

#include <cstddef>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/grids/mesh.hpp"

namespace floeplan::ingest {

/// The four-sided cells of points that are numbered [row][column]. Points that are not finite, and cells whose sides
/// are far longer than most (across the fold or the seam of a global grid, or to places that a model never filled
/// in), are left out.
[[nodiscard]] ocean::Mesh mesh_of_rows(std::vector<geo::LonLat> points, std::size_t columns);

}  // namespace floeplan::ingest

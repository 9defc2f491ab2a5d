#pragma once

#include <cstddef>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"

namespace floeplan::ingest {

/// The four-sided cells of points that are numbered [row][column]. Points that are not finite, and cells whose sides
/// are far longer than most (across the fold or the seam of a global grid, or to places that a model never filled
/// in), are left out.
[[nodiscard]] ocean::Mesh mesh_of_rows(std::vector<geo::LonLat> points, std::size_t columns);

/// The cells between the points of one component of a staggered grid, and those between the points of the other, whose
/// numbers follow. The first side of each cell lies along its component's axis: the rows of the first component, the
/// columns of the second.
[[nodiscard]] ocean::Mesh mesh_of_components(const Positions& first, const Positions& second);

}  // namespace floeplan::ingest

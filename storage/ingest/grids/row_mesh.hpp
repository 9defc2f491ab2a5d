#pragma once

#include <cstddef>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/grids/mesh.hpp"
#include "storage/ingest/formats/netcdf/position_tables.hpp"

namespace floeplan::ingest {

/// The four-sided cells between points that are numbered [row][column]. Points that are not finite are
/// dropped, and so are cells with sides far longer than most (across the fold or the seam of a global grid,
/// or to points without a valid position).
[[nodiscard]] ocean::Mesh mesh_of_rows(std::vector<geo::LonLat> points, std::size_t columns);

/// The cells between the points of the first component of a staggered grid, followed by those of the second,
/// whose point numbers continue after the first's. The first side of each cell lies along its component's
/// axis: the rows of the first component, the columns of the second.
[[nodiscard]] ocean::Mesh mesh_of_components(const Positions& first, const Positions& second);

}  // namespace floeplan::ingest

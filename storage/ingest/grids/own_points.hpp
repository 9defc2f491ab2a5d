#pragma once

#include <cstddef>
#include <vector>

#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/repository/fields/mesh_blocks.hpp"

namespace floeplan::ingest {

/// Points in rows that the store has no grid for. They stay where they are, joined to cells.
struct OwnPoints {
  repository::MeshInBlocks kept;  // those that lie in a cell, as they are stored
  ocean::HorizontalGrid grid;     // on which they are used
};

/// `places`  [row][column]; those that are not finite are dropped
/// Errors    the points enclose no area
[[nodiscard]] Checked<OwnPoints> own_points_of(std::vector<geo::LonLat> places, std::size_t columns);

}  // namespace floeplan::ingest

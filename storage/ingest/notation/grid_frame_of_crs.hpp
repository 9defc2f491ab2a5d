#pragma once

#include <optional>

#include "engine/geo/grid_frame.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"

class OGRSpatialReference;

namespace floeplan::ingest {

/// The engine's frame for a CRS whose coordinates can be used unchanged. These are longitude and latitude on WGS84 or
/// an ellipsoid that differs by less than a metre (GRS 1980), and in metres polar stereographic, transverse Mercator,
/// Mercator, Lambert's conformal conic, azimuthal and cylindrical equal-area, and Albers' projections; these also
/// on Hughes 1980 or a sphere (`earth_of`). A frame is checked against PROJ at three places, to 1e-6 degrees.
/// Outside  nullopt for every other CRS; the data are then kept at places of their own (`places_by_crs`)
[[nodiscard]] std::optional<geo::GridFrame> grid_frame_of(const OGRSpatialReference& crs);

/// Whether every node of a projected grid has a place of its own, and the meridian at which its projection is cut
/// does not cross it. Only then is each place found among the right nodes.
[[nodiscard]] bool lies_in_projection(const ocean::HorizontalGrid& grid);

}  // namespace floeplan::ingest

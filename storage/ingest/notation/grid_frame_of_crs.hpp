#pragma once

#include <optional>

#include "engine/geo/grid_frame.hpp"

class OGRSpatialReference;

namespace floeplan::ingest {

/// The engine's frame for a CRS whose coordinates can be used unchanged: longitude and latitude, polar
/// stereographic or transverse Mercator, in degrees or metres, on WGS84 or an ellipsoid that differs by less
/// than a metre (GRS80); polar stereographic also on Hughes 1980.
/// Outside  nullopt for every other CRS; the data are then kept at places of their own (`places_by_crs`)
[[nodiscard]] std::optional<geo::GridFrame> grid_frame_of(const OGRSpatialReference& crs);

/// Whether longitude and latitude of the CRS can be used as those of WGS84: they differ by metres only, or
/// they are on a sphere, and models that compute on a sphere mean the Earth's latitudes.
[[nodiscard]] bool has_latitudes_of_the_earth(const OGRSpatialReference& crs);

}  // namespace floeplan::ingest

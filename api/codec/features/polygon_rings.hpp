#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/geo/polygon.hpp"

namespace floeplan::codec {

/// Grid to which corners are rounded; a picture does not show more.
struct CornerGrid {
  double lon_deg{1e-4};
  double lat_deg{1e-4};
};

/// The rings of a polygon as GeoJSON: the outline first, closed; longitudes continue beyond 180 degrees where
/// it crosses the antimeridian. Corners are rounded to the grid, so that a line that two polygons share stays
/// one line. A ring without area after rounding is dropped.
/// Returns  an empty array if the outline is dropped
[[nodiscard]] nlohmann::json polygon_rings(const geo::Polygon& polygon, const CornerGrid& grid);

}  // namespace floeplan::codec

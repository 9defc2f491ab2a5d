#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/geo/polygon.hpp"

namespace floeplan::codec {

/// What corners are brought to: a picture shows no more.
struct CornerGrid {
  double lon_deg{1e-4};
  double lat_deg{1e-4};
};

/// The rings of a polygon as GeoJSON: the outline first, closed, longitudes running on past 180 degrees where it crosses the
/// antimeridian. Each corner is at the nearest node of the grid, so that what two polygons share stays one line; a ring of
/// which no area is left is left out.
/// Returns  an empty array where nothing is left of the outline
[[nodiscard]] nlohmann::json polygon_rings(const geo::Polygon& polygon, const CornerGrid& grid);

}  // namespace floeplan::codec

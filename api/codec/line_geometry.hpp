#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// A way as a GeoJSON LineString, or as a MultiLineString that is cut where it crosses the antimeridian (RFC 7946, 3.1.9).
[[nodiscard]] nlohmann::json line_geometry(const std::vector<geo::LonLat>& way);

}  // namespace floeplan::codec

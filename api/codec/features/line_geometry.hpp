#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// A way as a GeoJSON LineString, or as a MultiLineString that is cut where it crosses the antimeridian (RFC 7946,
/// 3.1.9).
/// `heights_m`  above the surface, of each place; empty: the line has none
[[nodiscard]] nlohmann::json line_geometry(const std::vector<geo::LonLat>& way,
                                           const std::vector<double>& heights_m = {});

}  // namespace floeplan::codec

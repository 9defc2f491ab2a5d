#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/geo/lon_lat.hpp"

namespace floeplan::codec {

/// A line as a GeoJSON LineString, or, if it crosses the antimeridian, as a MultiLineString cut there (RFC
/// 7946, 3.1.9).
/// `heights_m`  height of each position above the surface; empty: no heights
[[nodiscard]] nlohmann::json line_geometry(const std::vector<geo::LonLat>& way,
                                           const std::vector<double>& heights_m = {});

}  // namespace floeplan::codec

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "api/codec/reading/input_reader.hpp"
#include "engine/ocean/zone.hpp"

namespace floeplan::codec {

/// The member `areas`: a GeoJSON FeatureCollection (or one Feature) of Polygons and MultiPolygons. Properties:
/// kind ("no_go" or "stay_in", required), name, from, until (ISO 8601 with zone), top_m, bottom_m; others are left
/// alone, because map programs add their own, except names under which tables hold one of these.
/// Errors   more than 1,000 features or 100,000 corners in all; what is wrong with each feature
[[nodiscard]] std::vector<ocean::Zone> read_areas(InputReader& reader);

/// The zones as a FeatureCollection, every default written out.
[[nodiscard]] nlohmann::json areas_json(const std::vector<ocean::Zone>& zones);

}  // namespace floeplan::codec

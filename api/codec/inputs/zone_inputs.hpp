#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "api/codec/reading/input_reader.hpp"
#include "engine/ocean/zone.hpp"

namespace floeplan::codec {

/// Reads the member `areas`: a GeoJSON FeatureCollection (or one Feature) of Polygons and MultiPolygons.
/// Properties: kind ("no_go" or "stay_in", required), name, from, until (ISO 8601 with zone), top_m,
/// bottom_m. Other properties are ignored, because map programs add their own; but names that tables use for
/// one of these are refused.
/// Errors   more than 1,000 features or 100,000 corners in all; the faults of each feature
[[nodiscard]] std::vector<ocean::Zone> read_areas(InputReader& reader);

/// The zones as a FeatureCollection, with all defaults filled in.
[[nodiscard]] nlohmann::json areas_json(const std::vector<ocean::Zone>& zones);

}  // namespace floeplan::codec

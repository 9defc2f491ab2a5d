#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/planning/find_isochrones.hpp"

namespace floeplan::codec {

/// The isochrones as a GeoJSON FeatureCollection (RFC 7946): one MultiPolygon for each number of hours.
/// Additional members are the place and time of the request, the search, the data used and the warnings.
/// Positions are rounded to 1e-6 degrees (10 cm).
[[nodiscard]] nlohmann::json reach_document(const planning::Isochrones& reach,
                                            const planning::IsochroneRequest& request,
                                            const std::string& name);

}  // namespace floeplan::codec

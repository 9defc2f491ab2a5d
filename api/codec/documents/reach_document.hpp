#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/planning/find_isochrones.hpp"

namespace floeplan::codec {

/// The areas as a GeoJSON FeatureCollection (RFC 7946): one MultiPolygon for each number of hours, with the request's
/// place and time, the search, the data used and the warnings as further members. Positions are rounded to 1e-6
/// degrees (10 cm).
[[nodiscard]] nlohmann::json reach_document(const planning::Isochrones& reach,
                                            const planning::IsochroneRequest& request,
                                            const std::string& name);

}  // namespace floeplan::codec

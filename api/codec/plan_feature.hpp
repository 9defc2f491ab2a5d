#pragma once

#include <nlohmann/json_fwd.hpp>

#include "storage/repository/plan_repository.hpp"

namespace floeplan::codec {

/// A stored plan as a GeoJSON Feature (LineString; MultiLineString, cut at 180 degrees, where the route
/// crosses the antimeridian). Properties: the plan document, name and created.
/// Errors   std::runtime_error when the stored document is not one
[[nodiscard]] nlohmann::json plan_feature(const repository::PlanRecord& plan);

}  // namespace floeplan::codec

#pragma once

#include <nlohmann/json_fwd.hpp>

#include "storage/repository/work/plan_repository.hpp"

namespace floeplan::codec {

/// A stored plan for map programs: a GeoJSON FeatureCollection of the route (as plan_feature gives it) and,
/// in their order, its waypoints as Points with their row of the plan document as properties.
/// Errors   std::runtime_error or nlohmann::json::exception when the stored document is not one
[[nodiscard]] nlohmann::json plan_geojson(const repository::PlanRecord& plan);

}  // namespace floeplan::codec

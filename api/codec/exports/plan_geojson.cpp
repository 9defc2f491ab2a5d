#include "api/codec/exports/plan_files.hpp"
#include "api/codec/features/plan_feature.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

using nlohmann::json;

json plan_geojson(const repository::PlanRecord& plan) {
  const json route = plan_feature(plan);

  json features = json::array({route});
  for (const json& waypoint : route.at("properties").at("waypoints")) {
    const json position = json::array({waypoint.at("lon"), waypoint.at("lat")});
    features.push_back({{"type", "Feature"},
                        {"geometry", {{"type", "Point"}, {"coordinates", position}}},
                        {"properties", waypoint}});
  }
  return {{"type", "FeatureCollection"}, {"features", std::move(features)}};
}

}  // namespace floeplan::codec

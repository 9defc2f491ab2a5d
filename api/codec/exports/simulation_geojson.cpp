
#include "api/codec/exports/simulation_exports.hpp"
#include "api/codec/features/line_geometry.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

json feature(json geometry, json properties) {
  return {{"type", "Feature"}, {"geometry", std::move(geometry)}, {"properties", std::move(properties)}};
}

json line_feature(const json& flight, const char* lon, const char* lat, const char* role) {
  const json& track = flight.at("track");
  std::vector<geo::LonLat> way;
  for (std::size_t i = 0; i < track.at(lon).size(); ++i) {
    const geo::LonLat place{track.at(lon)[i].get<double>(), track.at(lat)[i].get<double>()};
    if (way.empty() || !(place == way.back())) way.push_back(place);
  }
  if (way.size() == 1) way.push_back(way.front());  // a LineString needs at least two positions
  json properties{{"role", role}, {"run", flight.at("run")}};
  for (const char* key :
       {"seed", "end", "end_reason", "departure", "finished", "travel_time_s", "distance_m", "energy_j"})
    properties[key] = flight.at(key);
  return feature(line_geometry(way), std::move(properties));
}

json point_feature(const json& flight, const json& at, const char* role) {
  json properties = at;
  properties["role"] = role;
  properties["run"] = flight.at("run");
  return feature({{"type", "Point"}, {"coordinates", json::array({at.at("lon"), at.at("lat")})}},
                 std::move(properties));
}

}  // namespace

json simulation_geojson(const json& simulation, const std::vector<json>& flights) {
  json features = json::array();
  for (const json& flight : flights) {
    features.push_back(line_feature(flight, "lon", "lat", "true track"));
    features.push_back(line_feature(flight, "believed_lon", "believed_lat", "estimated track"));
    for (const json& event : flight.at("events")) features.push_back(point_feature(flight, event, "event"));
    for (const json& approach : flight.at("approaches"))
      features.push_back(point_feature(flight, approach, "closest approach"));
  }
  return {{"type", "FeatureCollection"},
          {"simulation_id", simulation.at("simulation_id")},
          {"plan_id", simulation.at("plan_id")},
          {"features", std::move(features)}};
}

}  // namespace floeplan::codec

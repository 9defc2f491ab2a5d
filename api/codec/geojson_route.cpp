#include "api/codec/foreign_members.hpp"
#include "api/codec/json_text.hpp"
#include "api/codec/route_formats.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

/// The first LineString below this value, or its points where it has no line.
void find_geojson(const json& value, std::vector<json>& line, std::vector<json>& points) {
  if (!value.is_object()) return;
  const std::string type = text_at(value, "type");
  if (type == "FeatureCollection" && value.contains("features") && value["features"].is_array()) {
    for (const json& feature : value["features"]) find_geojson(feature, line, points);
  } else if (type == "Feature" && value.contains("geometry")) {
    find_geojson(value["geometry"], line, points);
  } else if (value.contains("coordinates")) {
    const json& coordinates = value["coordinates"];
    if (type == "LineString" && line.empty() && coordinates.is_array())
      line.assign(coordinates.begin(), coordinates.end());
    if (type == "Point") points.push_back(coordinates);
  }
}

}  // namespace

RoutePlaces read_geojson(std::string_view bytes) {
  const auto document = parse_json(bytes);
  if (!document) return route_fault("file", document.error());
  std::vector<json> line;
  std::vector<json> points;
  find_geojson(*document, line, points);
  const auto& positions = line.empty() ? points : line;
  if (positions.empty()) return route_fault("file", "holds no LineString and no Point");

  std::vector<geo::LonLat> places;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const json& position = positions[i];
    const bool numbers =
        position.is_array() && position.size() >= 2 && position[0].is_number() && position[1].is_number();
    if (!numbers || !geo::is_valid({position[0].get<double>(), position[1].get<double>()}))
      return route_fault("position " + std::to_string(i), "is not [longitude, latitude] in degrees");
    places.push_back({position[0].get<double>(), position[1].get<double>()});
  }
  return places;
}

}  // namespace floeplan::codec

#include "server/cli/output/figure_geojson.hpp"

#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;
using reproduction::Figure;

/// Length of a degree of the WGS84 equator.
constexpr double metres_per_degree = 111'319.490'793;

json plane_position(geo::PlanePoint point) { return {point.x_m, point.y_m}; }

json plane_positions(const std::vector<geo::PlanePoint>& points) {
  json positions = json::array();
  for (const geo::PlanePoint point : points) positions.push_back(plane_position(point));
  return positions;
}

/// The same positions, however deep in lists, on the map.
json on_map(const json& plane, double unit_m) {
  json result = json::array();
  for (const json& each : plane) {
    result.push_back(each.is_array() ? on_map(each, unit_m)
                                     : json(each.get<double>() * unit_m / metres_per_degree));
  }
  return result;
}

json feature(const Figure& figure, const char* type, const json& plane, json properties) {
  properties["plane_xy"] = plane;
  return {{"type", "Feature"},
          {"geometry", {{"type", type}, {"coordinates", on_map(plane, figure.unit_m)}}},
          {"properties", std::move(properties)}};
}

void add_panel(json& features, const Figure& figure, const reproduction::FigurePanel& panel) {
  for (const auto& path : panel.paths) {
    if (path.points.size() < 2) continue;  // at the departure there is no line yet
    features.push_back(feature(figure, "LineString", plane_positions(path.points),
                               {{"kind", "path"},
                                {"name", path.name},
                                {"travel_time", path.travel_time},
                                {"stroke", path.colour},
                                {"panel", panel.title}}));
  }
  for (const auto& obstacle : panel.obstacles) {
    const std::vector<geo::PlanePoint> ring{obstacle.low,
                                            {obstacle.high.x_m, obstacle.low.y_m},
                                            obstacle.high,
                                            {obstacle.low.x_m, obstacle.high.y_m},
                                            obstacle.low};
    features.push_back(feature(figure, "Polygon", json::array({plane_positions(ring)}),
                               {{"kind", "obstacle"}, {"panel", panel.title}}));
  }
  for (const auto& arrow : panel.arrows) {
    features.push_back(feature(figure, "Point", plane_position(arrow.at),
                               {{"kind", "current"},
                                {"x_velocity", arrow.current.x_m_s},
                                {"y_velocity", arrow.current.y_m_s},
                                {"panel", panel.title}}));
  }
  if (panel.vehicle) {
    features.push_back(feature(figure, "Point", plane_position(*panel.vehicle),
                               {{"kind", "vehicle"}, {"panel", panel.title}}));
  }
}

}  // namespace

json figure_geojson(const Figure& figure) {
  json features = json::array();
  features.push_back(feature(figure, "Point", plane_position(figure.start), {{"kind", "start"}}));
  features.push_back(feature(figure, "Point", plane_position(figure.goal), {{"kind", "goal"}}));
  for (const auto& panel : figure.panels) add_panel(features, figure, panel);
  return {{"type", "FeatureCollection"},
          {"title", figure.title},
          {"note",
           "A model water that lies nowhere on Earth: on the map its origin is at 0 N 0 E and one unit of "
           "its plane is " +
               std::to_string(static_cast<int>(figure.unit_m)) +
               " m. The property plane_xy has the coordinates x, y in the plane's own units."},
          {"features", std::move(features)}};
}

}  // namespace floeplan::cli

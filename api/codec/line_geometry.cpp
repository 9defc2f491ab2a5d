#include "api/codec/line_geometry.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace floeplan::codec {

using nlohmann::json;

json line_geometry(const std::vector<geo::LonLat>& way) {
  json lines = json::array({json::array()});
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i > 0 && std::abs(way[i].lon_deg - way[i - 1].lon_deg) > 180.0) {
      const double step = geo::longitude_difference(way[i - 1].lon_deg, way[i].lon_deg);
      const double edge = step > 0.0 ? 180.0 : -180.0;
      const double share = step == 0.0 ? 0.0 : (edge - way[i - 1].lon_deg) / step;
      const double lat = way[i - 1].lat_deg + share * (way[i].lat_deg - way[i - 1].lat_deg);
      lines.back().push_back({edge, lat});
      lines.push_back(json::array({json::array({-edge, lat})}));
    }
    lines.back().push_back({way[i].lon_deg, way[i].lat_deg});
  }
  if (lines.size() == 1) return {{"type", "LineString"}, {"coordinates", lines.front()}};
  return {{"type", "MultiLineString"}, {"coordinates", lines}};
}

}  // namespace floeplan::codec

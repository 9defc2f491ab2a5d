#include "api/codec/features/line_geometry.hpp"

#include <cmath>

#include "storage/json/json.hpp"

namespace floeplan::codec {

using nlohmann::json;

json line_geometry(const std::vector<geo::LonLat>& way, const std::vector<double>& heights_m) {
  json lines = json::array({json::array()});
  const auto position = [&](double lon_deg, double lat_deg, std::size_t before, double share) {
    json place = json::array({lon_deg, lat_deg});
    if (heights_m.empty()) return place;
    const double next_m = share > 0.0 ? heights_m[before + 1] : heights_m[before];
    place.push_back(std::lerp(heights_m[before], next_m, share));
    return place;
  };
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (i > 0 && std::abs(way[i].lon_deg - way[i - 1].lon_deg) > 180.0) {
      const double step = geo::longitude_difference(way[i - 1].lon_deg, way[i].lon_deg);
      const double edge = step > 0.0 ? 180.0 : -180.0;
      const double share = step == 0.0 ? 0.0 : (edge - way[i - 1].lon_deg) / step;
      const double lat = way[i - 1].lat_deg + share * (way[i].lat_deg - way[i - 1].lat_deg);
      lines.back().push_back(position(edge, lat, i - 1, share));
      lines.push_back(json::array({position(-edge, lat, i - 1, share)}));
    }
    lines.back().push_back(position(way[i].lon_deg, way[i].lat_deg, i, 0.0));
  }
  if (lines.size() == 1) return {{"type", "LineString"}, {"coordinates", lines.front()}};
  return {{"type", "MultiLineString"}, {"coordinates", lines}};
}

}  // namespace floeplan::codec

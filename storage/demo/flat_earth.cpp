#include "storage/demo/flat_earth.hpp"

#include <algorithm>
#include <limits>

namespace floeplan::demo {

BesideLine beside(std::span<const geo::LonLat> line, geo::LonLat place, const FlatEarth& earth) {
  BesideLine nearest{std::numeric_limits<double>::infinity(), 0.0};
  double length_m = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double leg_x = (line[i].lon_deg - line[i - 1].lon_deg) * earth.metres_per_degree_lon();
    const double leg_y = (line[i].lat_deg - line[i - 1].lat_deg) * metres_per_degree_lat;
    const double x = (place.lon_deg - line[i - 1].lon_deg) * earth.metres_per_degree_lon();
    const double y = (place.lat_deg - line[i - 1].lat_deg) * metres_per_degree_lat;
    const double leg_m = std::hypot(leg_x, leg_y);
    const double share = std::clamp((x * leg_x + y * leg_y) / (leg_m * leg_m), 0.0, 1.0);

    const double across_m = std::hypot(x - share * leg_x, y - share * leg_y);
    if (across_m < nearest.across_m) nearest = {across_m, length_m + share * leg_m};
    length_m += leg_m;
  }
  return nearest;
}

}  // namespace floeplan::demo

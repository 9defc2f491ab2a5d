#include "engine/planning/plane/lon_lat_box.hpp"

#include <span>
#include <vector>

namespace floeplan::planning::plane {

geo::BoundingBox lon_lat_box(const PlaneBox& box, const geo::LocalProjection& projection) {
  std::vector<geo::LonLat> rim;
  constexpr int samples = 32;
  for (int i = 0; i <= samples; ++i) {
    const double x = box.low.x_m + box.width_m() * i / samples;
    const double y = box.low.y_m + box.height_m() * i / samples;
    for (const geo::PlanePoint point : {geo::PlanePoint{x, box.low.y_m}, geo::PlanePoint{x, box.high.y_m},
                                        geo::PlanePoint{box.low.x_m, y}, geo::PlanePoint{box.high.x_m, y}}) {
      rim.push_back(projection.to_lon_lat(point));
    }
  }
  geo::BoundingBox area = geo::bounding_box(std::span<const geo::LonLat>{rim});
  for (const double pole_deg : {90.0, -90.0}) {
    const bool same_side = pole_deg * projection.origin().lat_deg > 0.0;
    if (same_side && box.contains(projection.to_plane({0.0, pole_deg}))) {
      (pole_deg > 0.0 ? area.north_deg : area.south_deg) = pole_deg;
      area.west_deg = -180.0;
      area.east_deg = 180.0;
    }
  }
  return area;
}

}  // namespace floeplan::planning::plane

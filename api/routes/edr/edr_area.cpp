#include "api/routes/edr/edr_area.hpp"

#include <algorithm>
#include <utility>

#include "engine/geo/geodesic.hpp"
#include "engine/geo/polygon_interior.hpp"
#include "engine/geo/united_boxes.hpp"

namespace floeplan::routes {

EdrArea area_of_box(const geo::BoundingBox& box) {
  const geo::LonLat middle{geo::wrap_longitude(box.west_deg + geo::width_deg(box) / 2.0),
                           (box.south_deg + box.north_deg) / 2.0};
  return {.box = box,
          .covers = [](geo::LonLat, double) { return true; },  // only places in the box are tested
          .middles = {middle},
          .places_on_edges = true};
}

EdrArea area_of_disc(geo::LonLat centre, core::Metres radius) {
  constexpr double metres_per_degree = 110'574.0;  // shortest degree of latitude on WGS84, at the equator
  return {.box = geo::grown({centre.lon_deg, centre.lat_deg, centre.lon_deg, centre.lat_deg}, radius),
          .covers =
              [=](geo::LonLat place, double tolerance_deg) {
                const core::Metres most{radius.value + tolerance_deg * metres_per_degree};
                return geo::geodesic_between(centre, place).length <= most;
              },
          .middles = {centre}};
}

EdrArea area_of_polygons(std::vector<geo::Polygon> polygons) {
  EdrArea area;
  std::vector<geo::BoundingBox> boxes;
  for (const geo::Polygon& polygon : polygons) {
    boxes.push_back(geo::bounding_box(polygon));
    if (const auto middle = geo::interior_point(polygon)) area.middles.push_back(*middle);
  }
  area.box = geo::united(boxes);
  area.covers = [polygons = std::move(polygons)](geo::LonLat place, double tolerance_deg) {
    return std::ranges::any_of(
        polygons, [&](const geo::Polygon& polygon) { return geo::covers(polygon, place, tolerance_deg); });
  };
  return area;
}

}  // namespace floeplan::routes

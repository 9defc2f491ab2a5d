#include "engine/geo/polygon.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::geo {
namespace {

/// Even-odd rule along the meridian through `place`; longitudes are taken relative to it, so the antimeridian
/// is no seam.
/// A corner's side of that meridian is the same for both of its edges: otherwise a corner on it would be
/// crossed once.
bool inside(const Ring& ring, LonLat place) {
  bool is_inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const double a = longitude_difference(place.lon_deg, ring[j].lon_deg);
    const double b = longitude_difference(place.lon_deg, ring[i].lon_deg);
    const bool behind_the_globe = std::abs(a - b) > 180.0;
    if ((a > 0.0) == (b > 0.0) || behind_the_globe) continue;
    const double crossing_lat = ring[j].lat_deg + (ring[i].lat_deg - ring[j].lat_deg) * a / (a - b);
    if (crossing_lat > place.lat_deg) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace

bool contains(const Polygon& polygon, LonLat place) {
  if (polygon.outer.empty() || !inside(polygon.outer, place)) return false;
  return std::ranges::none_of(polygon.holes, [&](const Ring& hole) { return inside(hole, place); });
}

BoundingBox bounding_box(const Polygon& polygon) {
  return bounding_box(std::span<const LonLat>{polygon.outer});
}

}  // namespace floeplan::geo

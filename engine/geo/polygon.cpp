#include "engine/geo/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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
  const Ring& ring = polygon.outer;
  if (ring.empty()) throw std::invalid_argument{"bounding_box needs at least one place"};
  const double first_deg = wrap_longitude(ring.front().lon_deg);
  BoundingBox box{first_deg, ring.front().lat_deg, first_deg, ring.front().lat_deg};
  double lon_deg = 0.0;  // counted from the first corner on, without a seam
  double west_deg = 0.0;
  double east_deg = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LonLat& next = ring[(i + 1) % ring.size()];
    box.south_deg = std::min(box.south_deg, next.lat_deg);
    box.north_deg = std::max(box.north_deg, next.lat_deg);
    lon_deg += longitude_difference(ring[i].lon_deg, next.lon_deg);
    if (lon_deg < west_deg) {
      west_deg = lon_deg;
      box.west_deg = wrap_longitude(next.lon_deg);
    }
    if (lon_deg > east_deg) {
      east_deg = lon_deg;
      box.east_deg = wrap_longitude(next.lon_deg);
    }
  }
  constexpr double rounding_deg = 1e-9;
  if (east_deg - west_deg >= 360.0 - rounding_deg) return {-180.0, box.south_deg, 180.0, box.north_deg};
  return box;
}

}  // namespace floeplan::geo

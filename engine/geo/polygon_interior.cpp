#include "engine/geo/polygon_interior.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/core/units.hpp"

namespace floeplan::geo {
namespace {

double off_edge_deg(LonLat place, LonLat a, LonLat b) {
  const double ax = longitude_difference(place.lon_deg, a.lon_deg);
  const double bx = longitude_difference(place.lon_deg, b.lon_deg);
  const double ay = a.lat_deg - place.lat_deg;
  const double by = b.lat_deg - place.lat_deg;
  const bool behind_the_globe = std::abs(ax - bx) > 180.0;
  if (behind_the_globe) return INFINITY;
  const double length2 = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
  const double share =
      length2 > 0.0 ? std::clamp(-(ax * (bx - ax) + ay * (by - ay)) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(ax + share * (bx - ax), ay + share * (by - ay));
}

bool is_near_edge(const Ring& ring, LonLat place, double tolerance_deg) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (off_edge_deg(place, ring[i], ring[(i + 1) % ring.size()]) <= tolerance_deg) return true;
  return false;
}

struct Band {
  double south_deg{};
  double north_deg{};
  [[nodiscard]] double height_deg() const { return north_deg - south_deg; }
};

/// Bands between the parallels of consecutive corners, the highest band first. No corner lies inside a band.
std::vector<Band> bands_of(const Polygon& polygon) {
  constexpr std::size_t enough = 32;  // to find a wide one; a polygon may have as many bands as corners
  std::vector<double> latitudes;
  for (const LonLat corner : polygon.outer) latitudes.push_back(corner.lat_deg);
  for (const Ring& hole : polygon.holes)
    for (const LonLat corner : hole) latitudes.push_back(corner.lat_deg);
  std::ranges::sort(latitudes);
  std::vector<Band> bands;
  for (std::size_t i = 1; i < latitudes.size(); ++i)
    if (latitudes[i] > latitudes[i - 1]) bands.push_back({latitudes[i - 1], latitudes[i]});
  std::ranges::stable_sort(bands, std::greater{}, &Band::height_deg);
  if (bands.size() > enough) bands.resize(enough);
  return bands;
}

void add_crossings(const Ring& ring, double lat_deg, std::vector<double>& crossings_deg) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LonLat a = ring[i];
    const LonLat b = ring[(i + 1) % ring.size()];
    if ((a.lat_deg > lat_deg) == (b.lat_deg > lat_deg)) continue;
    const double share = (lat_deg - a.lat_deg) / (b.lat_deg - a.lat_deg);
    crossings_deg.push_back(wrap_longitude(a.lon_deg + share * longitude_difference(a.lon_deg, b.lon_deg)));
  }
}

/// The longest stretch of the parallel inside the polygon: its length, in degrees of latitude, and its
/// middle.
std::optional<std::pair<double, LonLat>> widest_stretch(const Polygon& polygon, double lat_deg) {
  constexpr double rounding_deg = 1e-9;
  std::vector<double> crossings_deg;
  add_crossings(polygon.outer, lat_deg, crossings_deg);
  for (const Ring& hole : polygon.holes) add_crossings(hole, lat_deg, crossings_deg);
  if (crossings_deg.empty()) return std::nullopt;
  std::ranges::sort(crossings_deg);
  std::vector<std::pair<double, double>> stretches;  // length and western end of each
  for (std::size_t i = 0; i < crossings_deg.size(); ++i) {
    const bool is_last = i + 1 == crossings_deg.size();
    const double end = is_last ? crossings_deg.front() + 360.0 : crossings_deg[i + 1];
    if (end - crossings_deg[i] > rounding_deg)
      stretches.emplace_back(end - crossings_deg[i], crossings_deg[i]);
  }
  std::ranges::stable_sort(stretches, std::greater{}, &std::pair<double, double>::first);
  for (const auto& [length_deg, from_deg] : stretches) {
    const LonLat middle{wrap_longitude(from_deg + length_deg / 2.0), lat_deg};
    if (contains(polygon, middle))
      return std::pair{length_deg * std::cos(core::degrees_to_radians(lat_deg)), middle};
  }
  return std::nullopt;
}

}  // namespace

bool covers(const Polygon& polygon, LonLat place, double tolerance_deg) {
  if (contains(polygon, place) || is_near_edge(polygon.outer, place, tolerance_deg)) return true;
  return std::ranges::any_of(polygon.holes,
                             [&](const Ring& hole) { return is_near_edge(hole, place, tolerance_deg); });
}

std::optional<LonLat> interior_point(const Polygon& polygon) {
  std::optional<LonLat> best;
  double most_room_deg = 0.0;
  for (const Band& band : bands_of(polygon)) {
    if (band.height_deg() <= most_room_deg) break;
    const auto stretch = widest_stretch(polygon, (band.south_deg + band.north_deg) / 2.0);
    if (!stretch) continue;
    const double room_deg = std::min(stretch->first, band.height_deg());
    if (room_deg <= most_room_deg) continue;
    most_room_deg = room_deg;
    best = stretch->second;
  }
  return best;
}

}  // namespace floeplan::geo

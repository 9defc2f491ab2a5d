#include "engine/geo/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace floeplan::geo {
namespace {

/// Whether the edge from a to b crosses the meridian of the place north of it. Longitudes are relative to the
/// place, so the antimeridian is no seam.
/// A corner on that meridian counts as lying on the same side for both its edges. Otherwise it could count as
/// one crossing.
bool passes_north_of(LonLat place, LonLat a, LonLat b) {
  const double a_deg = longitude_difference(place.lon_deg, a.lon_deg);
  const double b_deg = longitude_difference(place.lon_deg, b.lon_deg);
  const bool behind_the_globe = std::abs(a_deg - b_deg) > 180.0;
  if ((a_deg > 0.0) == (b_deg > 0.0) || behind_the_globe) return false;
  return a.lat_deg + (b.lat_deg - a.lat_deg) * a_deg / (a_deg - b_deg) > place.lat_deg;
}

/// Even-odd rule.
bool inside(const Ring& ring, LonLat place) {
  bool is_inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    if (passes_north_of(place, ring[j], ring[i])) is_inside = !is_inside;
  return is_inside;
}

/// Places sorted by longitude, so that an edge is compared only with places between its ends.
class SortedPlaces {
 public:
  explicit SortedPlaces(std::span<const LonLat> places) {
    for (std::size_t i = 0; i < places.size(); ++i)
      sorted_.push_back({wrap_longitude(places[i].lon_deg), i, places[i]});
    std::ranges::sort(sorted_, {}, &Entry::lon_deg);
  }

  /// For each edge: inverts `is_inside` of every place that the edge passes north of.
  void cross(const Ring& ring, std::vector<bool>& is_inside) const {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const auto [west_deg, east_deg] =
          std::minmax({wrap_longitude(ring[j].lon_deg), wrap_longitude(ring[i].lon_deg)});
      const bool crosses_the_seam = east_deg - west_deg > 180.0;
      const auto compare = [&](double from_deg, double to_deg) {
        auto entry = std::ranges::lower_bound(sorted_, from_deg - rounding_deg, {}, &Entry::lon_deg);
        for (; entry != sorted_.end() && entry->lon_deg <= to_deg + rounding_deg; ++entry)
          if (passes_north_of(entry->place, ring[j], ring[i])) is_inside[entry->number].flip();
      };
      if (!crosses_the_seam) compare(west_deg, east_deg);
      if (crosses_the_seam) {
        compare(-180.0, west_deg);
        compare(east_deg, 180.0);
      }
    }
  }

 private:
  static constexpr double rounding_deg = 1e-9;
  struct Entry {
    double lon_deg;
    std::size_t number;
    LonLat place;
  };
  std::vector<Entry> sorted_;
};

}  // namespace

std::size_t Polygon::bytes() const {
  std::size_t corners = outer.size();
  for (const Ring& hole : holes) corners += hole.size();
  return corners * sizeof(LonLat);
}

bool contains(const Polygon& polygon, LonLat place) {
  if (polygon.outer.empty() || !inside(polygon.outer, place)) return false;
  return std::ranges::none_of(polygon.holes, [&](const Ring& hole) { return inside(hole, place); });
}

std::vector<bool> contained_in_any(std::span<const Polygon> polygons, std::span<const LonLat> places) {
  std::vector<bool> contained(places.size(), false);
  if (places.empty()) return contained;
  const SortedPlaces sorted{places};
  for (const Polygon& polygon : polygons) {
    std::vector<bool> in_this(places.size(), false);
    sorted.cross(polygon.outer, in_this);
    for (const Ring& hole : polygon.holes) {
      std::vector<bool> in_hole(places.size(), false);
      sorted.cross(hole, in_hole);
      for (std::size_t i = 0; i < places.size(); ++i) in_this[i] = in_this[i] && !in_hole[i];
    }
    for (std::size_t i = 0; i < places.size(); ++i) contained[i] = contained[i] || in_this[i];
  }
  return contained;
}

BoundingBox bounding_box(const Polygon& polygon) {
  const Ring& ring = polygon.outer;
  if (ring.empty()) throw std::invalid_argument{"bounding_box needs at least one place"};
  const double first_deg = wrap_longitude(ring.front().lon_deg);
  BoundingBox box{first_deg, ring.front().lat_deg, first_deg, ring.front().lat_deg};
  double lon_deg = 0.0;  // counted from the first corner, without a seam
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

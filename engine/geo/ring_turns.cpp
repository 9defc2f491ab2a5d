#include "engine/geo/ring_turns.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace floeplan::geo {
namespace {

constexpr double widest_edge_deg = 90.0;

}  // namespace

double turn_of(const Ring& ring) {
  double turn_deg = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    turn_deg += longitude_difference(ring[i].lon_deg, ring[(i + 1) % ring.size()].lon_deg);
  return 360.0 * std::round(turn_deg / 360.0);
}

std::string doubt_in_turns(const Polygon& polygon) {
  std::vector<const Ring*> rings{&polygon.outer};
  for (const Ring& hole : polygon.holes) rings.push_back(&hole);
  for (const Ring* const ring : rings) {
    if (turn_of(*ring) != 0.0)
      return "leads round a pole, but an outline in longitude and latitude cannot; divide it along meridians";
    double widest_deg = 0.0;
    for (std::size_t i = 0; i < ring->size(); ++i)
      widest_deg = std::max(widest_deg, std::abs(longitude_difference(
                                            (*ring)[i].lon_deg, (*ring)[(i + 1) % ring->size()].lon_deg)));
    if (widest_deg < widest_edge_deg) continue;
    char text[160];
    std::snprintf(
        text, sizeof text,
        "has an edge of %.4g degrees of longitude, which could lead round the Earth either way; put "
        "corners between its ends",
        widest_deg);
    return text;
  }
  return "";
}

Ring counted_on(const Ring& ring, double from_deg) {
  Ring result;
  result.reserve(ring.size());
  for (const LonLat corner : ring) {
    const double before_deg = result.empty() ? from_deg : result.back().lon_deg;
    const double turns = std::round((before_deg - corner.lon_deg) / 360.0);
    result.push_back({corner.lon_deg + 360.0 * turns, corner.lat_deg});
  }
  return result;
}

}  // namespace floeplan::geo

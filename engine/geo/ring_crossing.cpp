#include "engine/geo/ring_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/geo/ring_turns.hpp"

namespace floeplan::geo {
namespace {

constexpr double touching_deg = 1e-7;  // a centimetre, the last decimal on charts
constexpr std::size_t most_pairs = 50'000'000;

/// An edge with longitudes that continue without a jump.
struct Edge {
  LonLat west;
  LonLat east;
};

std::vector<Edge> edges_from_west(const Ring& ring) {
  const Ring places = counted_on(ring, ring.front().lon_deg);
  std::vector<Edge> edges;
  edges.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const LonLat& a = places[i];
    LonLat b = places[(i + 1) % places.size()];
    b.lon_deg = a.lon_deg + longitude_difference(a.lon_deg, b.lon_deg);
    edges.push_back(a.lon_deg <= b.lon_deg ? Edge{a, b} : Edge{b, a});
  }
  std::ranges::sort(edges, {}, [](const Edge& edge) { return edge.west.lon_deg; });
  return edges;
}

/// Distance of the place to the left of the edge's line, in degrees; empty for an edge of no length.
double distance_left(const Edge& edge, LonLat place) {
  const double lon_deg = edge.east.lon_deg - edge.west.lon_deg;
  const double lat_deg = edge.east.lat_deg - edge.west.lat_deg;
  const double length_deg = std::hypot(lon_deg, lat_deg);
  if (length_deg == 0.0) return 0.0;
  return (lon_deg * (place.lat_deg - edge.west.lat_deg) - lat_deg * (place.lon_deg - edge.west.lon_deg)) /
         length_deg;
}

/// The place where two edges cross; empty if they do not.
std::optional<LonLat> crossing(const Edge& a, const Edge& b) {
  const auto [a_south, a_north] = std::minmax(a.west.lat_deg, a.east.lat_deg);
  const auto [b_south, b_north] = std::minmax(b.west.lat_deg, b.east.lat_deg);
  if (a_north < b_south || b_north < a_south) return std::nullopt;
  const auto parts = [](double one_deg, double other_deg) {
    return std::min(std::abs(one_deg), std::abs(other_deg)) > touching_deg &&
           (one_deg > 0.0) != (other_deg > 0.0);
  };
  const double west_deg = distance_left(b, a.west);
  const double east_deg = distance_left(b, a.east);
  if (!parts(west_deg, east_deg)) return std::nullopt;
  if (!parts(distance_left(a, b.west), distance_left(a, b.east))) return std::nullopt;
  const double share = west_deg / (west_deg - east_deg);
  return LonLat{wrap_longitude(std::lerp(a.west.lon_deg, a.east.lon_deg, share)),
                std::lerp(a.west.lat_deg, a.east.lat_deg, share)};
}

}  // namespace

RingCrossing find_crossing(const Ring& ring) {
  if (ring.size() < 4) return {};
  std::vector<Edge> beside;  // edges that reach at least as far east as the current edge
  std::size_t pairs = 0;
  for (const Edge& edge : edges_from_west(ring)) {
    std::erase_if(beside, [&](const Edge& earlier) { return earlier.east.lon_deg < edge.west.lon_deg; });
    pairs += beside.size();
    if (pairs > most_pairs) return {.place = std::nullopt, .is_looked_through = false};
    for (const Edge& earlier : beside)
      if (const auto place = crossing(earlier, edge)) return {.place = place};
    beside.push_back(edge);
  }
  return {};
}

}  // namespace floeplan::geo

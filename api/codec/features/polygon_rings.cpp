#include "api/codec/features/polygon_rings.hpp"

#include <cmath>

#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

/// Rounds to the grid, then to about a metre, finer than any grid: a product of step and count can have many
/// decimals.
double at_node(double degrees, double step_deg) {
  constexpr double written = 1e5;
  return std::round(std::round(degrees / step_deg) * step_deg * written) / written;
}

json closed_ring(const geo::Ring& ring, const CornerGrid& grid) {
  json result = json::array();
  if (ring.empty()) return result;
  double lon_deg = ring.front().lon_deg;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i > 0) lon_deg += geo::longitude_difference(ring[i - 1].lon_deg, ring[i].lon_deg);
    json position = json::array({at_node(lon_deg, grid.lon_deg), at_node(ring[i].lat_deg, grid.lat_deg)});
    if (result.empty() || result.back() != position) result.push_back(std::move(position));
  }
  while (result.size() > 1 && result.front() == result.back()) result.erase(result.size() - 1);
  if (result.size() < 3) return json::array();
  result.push_back(result.front());
  return result;
}

}  // namespace

json polygon_rings(const geo::Polygon& polygon, const CornerGrid& grid) {
  json rings = json::array();
  json outline = closed_ring(polygon.outer, grid);
  if (outline.empty()) return rings;
  rings.push_back(std::move(outline));
  for (const geo::Ring& hole : polygon.holes)
    if (json ring = closed_ring(hole, grid); !ring.empty()) rings.push_back(std::move(ring));
  return rings;
}

}  // namespace floeplan::codec

#pragma once

#include <algorithm>
#include <cmath>

#include "engine/geo/local_projection.hpp"
#include "engine/geo/polygon.hpp"

namespace floeplan::planning {

/// Calls `visit(a, b)` for the lines of a closed ring in the plane. A ring's edges are straight in longitude and
/// latitude and bend in the plane, so long ones come in pieces of at most 0.1 degrees.
template <class Visit>
void for_each_coast_line(const geo::Ring& ring, const geo::LocalProjection& projection, Visit&& visit) {
  constexpr double longest_piece_deg = 0.1;  // bends by about a metre at 70 degrees
  if (ring.empty()) return;
  geo::PlanePoint last = projection.to_plane(ring.back());
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const double dlon = geo::longitude_difference(ring[j].lon_deg, ring[i].lon_deg);
    const double dlat = ring[i].lat_deg - ring[j].lat_deg;
    const double longest_deg = std::max(std::abs(dlon), std::abs(dlat));
    const int pieces = std::max(1, static_cast<int>(std::ceil(longest_deg / longest_piece_deg)));
    for (int piece = 1; piece <= pieces; ++piece) {
      const double share = static_cast<double>(piece) / pieces;
      const geo::LonLat place{ring[j].lon_deg + share * dlon, ring[j].lat_deg + share * dlat};
      const geo::PlanePoint next = projection.to_plane(piece == pieces ? ring[i] : place);
      visit(last, next);
      last = next;
    }
  }
}

}  // namespace floeplan::planning

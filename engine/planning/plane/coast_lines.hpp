#pragma once

#include <algorithm>
#include <cmath>

#include "engine/geo/local_projection.hpp"
#include "engine/geo/polygon.hpp"
#include "engine/geo/ring_clipping.hpp"

namespace floeplan::planning::plane {

/// Calls `visit(a, b)` for the lines of a closed ring in the plane, where it lies in the projection's window.
/// The ring's edges are straight in longitude and latitude and bend in the plane. So long edges are visited
/// in pieces of at most 0.1 degrees.
template <class Visit>
void for_each_coast_line(const geo::Ring& ring, const geo::LocalProjection& projection, Visit&& visit) {
  constexpr double longest_piece_deg = 0.1;  // a piece bends by about a metre at 70 degrees latitude
  for (const geo::Ring& part : geo::clipped(ring, projection.window())) {
    geo::PlanePoint last = projection.to_plane(part.back());
    for (std::size_t i = 0, j = part.size() - 1; i < part.size(); j = i++) {
      const double dlon = part[i].lon_deg - part[j].lon_deg;
      const double dlat = part[i].lat_deg - part[j].lat_deg;
      const double longest_deg = std::max(std::abs(dlon), std::abs(dlat));
      const int pieces = std::max(1, static_cast<int>(std::ceil(longest_deg / longest_piece_deg)));
      for (int piece = 1; piece <= pieces; ++piece) {
        const double share = static_cast<double>(piece) / pieces;
        const geo::LonLat place{part[j].lon_deg + share * dlon, part[j].lat_deg + share * dlat};
        const geo::PlanePoint next = projection.to_plane(piece == pieces ? part[i] : place);
        visit(last, next);
        last = next;
      }
    }
  }
}

}  // namespace floeplan::planning::plane

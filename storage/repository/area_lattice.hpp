#pragma once

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::repository {

/// Whether `holds(place)` at all nodes of a lattice that cuts the area into `pieces` along either side, its edges
/// included.
template <class Holds>
[[nodiscard]] bool holds_all_over(const geo::BoundingBox& area, int pieces, const Holds& holds) {
  const double width_deg = geo::width_deg(area);
  for (int row = 0; row <= pieces; ++row) {
    for (int column = 0; column <= pieces; ++column) {
      const double lat_deg = area.south_deg + (area.north_deg - area.south_deg) * row / pieces;
      const double lon_deg = geo::wrap_longitude(area.west_deg + width_deg * column / pieces);
      if (!holds(geo::LonLat{lon_deg, lat_deg})) return false;
    }
  }
  return true;
}

}  // namespace floeplan::repository

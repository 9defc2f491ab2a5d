#pragma once

#include <cmath>
#include <span>

#include "engine/core/units.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::demo {

constexpr double metres_per_degree_lat = 111'500.0;

/// Converts between degrees and metres near one parallel. The error is at most 1 % over a degree of latitude,
/// small enough for invented data.
struct FlatEarth {
  double reference_lat_deg{};

  [[nodiscard]] double metres_per_degree_lon() const {
    return metres_per_degree_lat * std::cos(core::degrees_to_radians(reference_lat_deg));
  }
  [[nodiscard]] double distance_m(geo::LonLat a, geo::LonLat b) const {
    return std::hypot((b.lon_deg - a.lon_deg) * metres_per_degree_lon(),
                      (b.lat_deg - a.lat_deg) * metres_per_degree_lat);
  }
};

/// Position of a place relative to a line of several legs.
struct BesideLine {
  double across_m{};  // distance to the line, never negative
  double along_m{};   // along the line, from its start to the point nearest to the place
};

[[nodiscard]] BesideLine beside(std::span<const geo::LonLat> line, geo::LonLat place, const FlatEarth& earth);

}  // namespace floeplan::demo

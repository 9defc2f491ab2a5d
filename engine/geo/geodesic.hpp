#pragma once

#include "engine/core/units.hpp"
#include "engine/geo/bearing.hpp"
#include "engine/geo/lon_lat.hpp"

namespace floeplan::geo {

/// Shortest line between two places on WGS84.
/// Source   Karney 2013, Algorithms for geodesics, J. Geodesy 87, doi:10.1007/s00190-012-0578-z
///          (GeographicLib)
struct GeodesicLine {
  core::Metres length;
  Bearing course_at_start;
  Bearing course_at_end;
};

[[nodiscard]] GeodesicLine geodesic_between(LonLat from, LonLat to);

/// The end of the geodesic of this length that leaves `from` with this course.
[[nodiscard]] LonLat geodesic_destination(LonLat from, Bearing course, core::Metres distance);

}  // namespace floeplan::geo

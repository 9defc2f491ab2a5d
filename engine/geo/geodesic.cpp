#include "engine/geo/geodesic.hpp"

#include <GeographicLib/Geodesic.hpp>

namespace floeplan::geo {

GeodesicLine geodesic_between(LonLat from, LonLat to) {
  double length_m = 0.0;
  double start_deg = 0.0;
  double end_deg = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(from.lat_deg, from.lon_deg, to.lat_deg, to.lon_deg, length_m,
                                           start_deg, end_deg);
  return {core::Metres{length_m}, Bearing::degrees(start_deg), Bearing::degrees(end_deg)};
}

LonLat geodesic_destination(LonLat from, Bearing course, core::Metres distance) {
  LonLat to;
  GeographicLib::Geodesic::WGS84().Direct(from.lat_deg, from.lon_deg, course.degrees(), distance.value,
                                          to.lat_deg, to.lon_deg);
  return to;
}

}  // namespace floeplan::geo

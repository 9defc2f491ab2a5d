#include "engine/geo/lon_lat.hpp"

#include <cmath>

namespace floeplan::geo {

double wrap_longitude(double lon_deg) {
  if (lon_deg >= -180.0 && lon_deg < 180.0) return lon_deg;  // exactly unchanged: the sums below round
  const double turned = std::fmod(lon_deg + 180.0, 360.0);
  return turned < 0.0 ? turned + 180.0 : turned - 180.0;
}

double longitude_difference(double from_deg, double to_deg) { return wrap_longitude(to_deg - from_deg); }

bool is_valid(LonLat place) {
  return std::isfinite(place.lon_deg) && std::isfinite(place.lat_deg) && std::abs(place.lat_deg) <= 90.0 &&
         place.lon_deg >= -180.0 && place.lon_deg <= 360.0;
}

}  // namespace floeplan::geo

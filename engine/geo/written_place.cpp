#include "engine/geo/written_place.hpp"

namespace floeplan::geo {

std::optional<LonLat> written_place(double lon_deg, double lat_deg) {
  const bool is_west_of_all = lon_deg >= -360.0 && lon_deg < -180.0;
  const LonLat place{is_west_of_all ? lon_deg + 360.0 : lon_deg, lat_deg};
  if (!is_valid(place)) return std::nullopt;
  return LonLat{wrap_longitude(place.lon_deg), lat_deg};
}

}  // namespace floeplan::geo

#include "engine/geo/written_place.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace floeplan::geo {
namespace {

/// The angle is rounded only once, so that minutes never read 60.
std::string angle_in_minutes(double degrees, int width, char positive, char negative) {
  const long long thousandths = std::llround(std::abs(degrees) * 60'000.0);
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%0*lld°%06.3f′%c", width, thousandths / 60'000,
                static_cast<double>(thousandths % 60'000) / 1000.0, degrees < 0.0 ? negative : positive);
  return text.data();
}

}  // namespace

std::optional<LonLat> written_place(double lon_deg, double lat_deg) {
  const bool is_west_of_all = lon_deg >= -360.0 && lon_deg < -180.0;
  const LonLat place{is_west_of_all ? lon_deg + 360.0 : lon_deg, lat_deg};
  if (!is_valid(place)) return std::nullopt;
  return LonLat{wrap_longitude(place.lon_deg), lat_deg};
}

std::string latitude_text(double lat_deg) { return angle_in_minutes(lat_deg, 2, 'N', 'S'); }

std::string longitude_text(double lon_deg) {
  return angle_in_minutes(wrap_longitude(lon_deg), 3, 'E', 'W');
}

}  // namespace floeplan::geo

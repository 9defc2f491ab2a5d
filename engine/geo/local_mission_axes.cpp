#include "engine/geo/local_mission_axes.hpp"

#include <GeographicLib/TransverseMercator.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cmath>
#include <stdexcept>

namespace floeplan::geo {
namespace {

constexpr int zones = 60;
constexpr double zone_width_deg = 6.0;

double central_meridian_deg(int utm_zone) { return -183.0 + zone_width_deg * utm_zone; }

/// Clockwise angle in degrees from true north to the zone's grid north.
double convergence_deg(int utm_zone, LonLat place) {
  double x_m = 0.0;
  double y_m = 0.0;
  double convergence = 0.0;
  double scale = 0.0;
  GeographicLib::TransverseMercator::UTM().Forward(central_meridian_deg(utm_zone), place.lat_deg,
                                                   place.lon_deg, x_m, y_m, convergence, scale);
  return convergence;
}

}  // namespace

int utm_zone_of(LonLat place) {
  if (!is_valid(place)) throw std::invalid_argument{"a zone of the UTM grid needs a valid place"};
  return 1 + static_cast<int>((wrap_longitude(place.lon_deg) + 180.0) / zone_width_deg) % zones;
}

int standard_utm_zone_of(LonLat place) {
  if (!is_valid(place)) throw std::invalid_argument{"a zone of the UTM grid needs a valid place"};
  return GeographicLib::UTMUPS::StandardZone(place.lat_deg, place.lon_deg, GeographicLib::UTMUPS::UTM);
}

LocalMissionAxes::LocalMissionAxes(int utm_zone, core::Radians variation_west)
    : utm_zone_{utm_zone}, variation_west_{variation_west} {
  if (utm_zone < 1 || utm_zone > zones || !std::isfinite(variation_west.value))
    throw std::invalid_argument{"local mission coordinates need a zone of 1 to 60 and a variation"};
}

core::Radians LocalMissionAxes::turn_at(LonLat place) const {
  return variation_west_ - core::Radians{core::degrees_to_radians(convergence_deg(utm_zone_, place))};
}

VelocityEn LocalMissionAxes::to_true(VelocityLmc velocity, LonLat place) const {
  const double turn = turn_at(place).value;
  return {std::cos(turn) * velocity.x - std::sin(turn) * velocity.y,
          std::sin(turn) * velocity.x + std::cos(turn) * velocity.y};
}

VelocityLmc LocalMissionAxes::to_lmc(VelocityEn velocity, LonLat place) const {
  const double turn = turn_at(place).value;
  return {std::cos(turn) * velocity.east + std::sin(turn) * velocity.north,
          std::cos(turn) * velocity.north - std::sin(turn) * velocity.east};
}

}  // namespace floeplan::geo

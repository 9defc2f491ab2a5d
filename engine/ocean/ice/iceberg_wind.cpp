#include "engine/ocean/ice/iceberg_wind.hpp"

#include <cmath>
#include <numbers>

namespace floeplan::ocean {
namespace {

/// Ratio of the speed through the water to the wind speed if the Coriolis force is negligible: sqrt(rho_a
/// (rho_w - rho_i) / (rho_w rho_i) C_a / C_w) with C_a = 1.3 and C_w = 0.9, as in the source.
constexpr double windage = 0.0187;
constexpr double drag_of_water = 0.9;
constexpr double length_over_width = 1.62;
constexpr double earth_rotation_rad_s = 7.292115e-5;  // IERS Conventions 2010, table 1.2

}  // namespace

geo::VelocityEn moved_by_wind(geo::VelocityEn wind, core::Metres length, double latitude_deg) {
  const double speed_m_s = geo::strength(wind).value;
  if (speed_m_s <= 0.0) return {};
  const double coriolis_rad_s =
      2.0 * earth_rotation_rad_s * std::sin(latitude_deg * std::numbers::pi / 180.0);
  const double harmonic_length_m = length.value / (1.0 + length_over_width);
  // Ratio of the Coriolis force to the drag: the inverse of the source's Lambda.
  const double turning =
      std::numbers::pi * std::abs(coriolis_rad_s) * harmonic_length_m / (windage * drag_of_water * speed_m_s);
  const double square = 2.0 / (turning * turning + std::sqrt(std::pow(turning, 4) + 4.0));
  const double reach = windage / std::sqrt(turning * turning + square);
  const double ahead = reach * square;
  const double aside = std::copysign(reach * turning * std::sqrt(square), coriolis_rad_s);
  return {ahead * wind.east + aside * wind.north, ahead * wind.north - aside * wind.east};
}

}  // namespace floeplan::ocean

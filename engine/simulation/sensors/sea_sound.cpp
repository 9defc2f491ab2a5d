#include "engine/simulation/sensors/sea_sound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.hpp"

namespace floeplan::simulation {
namespace {

double power_of(double level_db) { return std::pow(10.0, level_db / 10.0); }

}  // namespace

double absorption_db_m(double frequency_khz, const SoundWater& water) {
  const double f2 = frequency_khz * frequency_khz;
  const double t = water.temperature_deg_c;
  const double z_km = water.depth_m / 1000.0;
  const double boric_khz = 0.78 * std::sqrt(water.salinity_g_kg / 35.0) * std::exp(t / 26.0);
  const double magnesium_khz = 42.0 * std::exp(t / 17.0);

  const double boric =
      0.106 * boric_khz * f2 / (f2 + boric_khz * boric_khz) * std::exp((water.ph - 8.0) / 0.56);
  const double magnesium = 0.52 * (1.0 + t / 43.0) * (water.salinity_g_kg / 35.0) * magnesium_khz * f2 /
                           (f2 + magnesium_khz * magnesium_khz) * std::exp(-z_km / 6.0);
  const double viscous = 0.00049 * f2 * std::exp(-(t / 27.0 + z_km / 17.0));
  return (boric + magnesium + viscous) / 1000.0;
}

double noise_spectrum_db(double frequency_khz, double wind_m_s) {
  const double wind_db = 50.0 + 7.5 * std::sqrt(wind_m_s) + 20.0 * std::log10(frequency_khz) -
                         40.0 * std::log10(frequency_khz + 0.4);
  const double thermal_db = -15.0 + 20.0 * std::log10(frequency_khz);
  return 10.0 * std::log10(power_of(wind_db) + power_of(thermal_db));
}

double surface_backscatter(double sine_of_grazing, double frequency_khz, double wind_m_s) {
  const double most = sine_of_grazing * sine_of_grazing / std::numbers::pi;
  if (sine_of_grazing <= 0.0 || wind_m_s <= 0.0) return 0.0;
  const double frequency_hz = 1000.0 * std::min(frequency_khz, 6.4);
  const double wind_knots = wind_m_s * 3600.0 / 1852.0;
  const double beta = 158.0 * std::pow(wind_knots * std::cbrt(frequency_hz), -0.58);
  const double grazing_deg = core::radians_to_degrees(std::asin(std::min(1.0, sine_of_grazing)));
  return std::min(most,
                  power_of(3.3 * beta * std::log10(grazing_deg / 30.0) - 42.4 * std::log10(beta) + 2.6));
}

}  // namespace floeplan::simulation

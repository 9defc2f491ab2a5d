#include "engine/simulation/sensors/sea_sound.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/core/units.hpp"
#include "engine/simulation/sensors/beam_pattern.hpp"

namespace floeplan::simulation::sea_sound_test {
namespace {

/// Francois and Garrison 1982, J. Acoust. Soc. Am. 72, doi:10.1121/1.388673: equations 1 to 13, total absorption,
/// dB/km.
double francois_garrison_db_km(double f_khz, double t, double s, double depth_m, double ph) {
  const double c = 1412.0 + 3.21 * t + 1.19 * s + 0.0167 * depth_m;
  const double a1 = 8.86 / c * std::pow(10.0, 0.78 * ph - 5.0);
  const double f1 = 2.8 * std::sqrt(s / 35.0) * std::pow(10.0, 4.0 - 1245.0 / (273.0 + t));
  const double a2 = 21.44 * s / c * (1.0 + 0.025 * t);
  const double p2 = 1.0 - 1.37e-4 * depth_m + 6.2e-9 * depth_m * depth_m;
  const double f2 = 8.17 * std::pow(10.0, 8.0 - 1990.0 / (273.0 + t)) / (1.0 + 0.0018 * (s - 35.0));
  const double a3 = 4.937e-4 - 2.59e-5 * t + 9.11e-7 * t * t - 1.50e-8 * t * t * t;  // up to 20 degrees
  const double p3 = 1.0 - 3.83e-5 * depth_m + 4.9e-10 * depth_m * depth_m;
  const double ff = f_khz * f_khz;
  return a1 * f1 * ff / (f1 * f1 + ff) + a2 * p2 * f2 * ff / (f2 * f2 + ff) + a3 * p3 * ff;
}

TEST(SeaSound, IsAbsorbedAsTheFullFormulaSaysWithinTenPerCent) {
  for (const double f_khz : {20.0, 75.0, 170.0, 260.0, 600.0}) {
    for (const double t : {-1.5, 0.0, 4.0, 10.0}) {
      for (const double depth_m : {0.0, 200.0, 1000.0}) {
        SoundWater water;
        water.temperature_deg_c = t;
        water.salinity_g_kg = 34.0;
        water.depth_m = depth_m;
        const double expected = francois_garrison_db_km(f_khz, t, 34.0, depth_m, 8.0);

        EXPECT_NEAR(1000.0 * absorption_db_m(f_khz, water) / expected, 1.0, 0.1)
            << f_khz << " kHz, " << t << " degrees, " << depth_m << " m";
      }
    }
  }
}

TEST(SeaSound, IsWindNoiseAtLowAndThermalNoiseAtHighFrequencies) {
  EXPECT_GT(noise_spectrum_db(20.0, 15.0), noise_spectrum_db(20.0, 2.0) + 5.0);
  EXPECT_NEAR(noise_spectrum_db(1000.0, 2.0), -15.0 + 60.0, 0.2);
}

TEST(SeaSound, ComesBackFromTheSurfaceAsChapmanAndHarrisFitted) {
  // beta = 158 (v f^(1/3))^-0.58 with 20 knots and 1 kHz: 10.94.. ; 30 degrees: -42.4 lg(beta) + 2.6 dB.
  const double beta = 158.0 * std::pow(200.0, -0.58);
  const double expected_db = -42.4 * std::log10(beta) + 2.6;
  const double found = surface_backscatter(0.5, 1.0, 20.0 * 1852.0 / 3600.0);

  EXPECT_NEAR(10.0 * std::log10(found), expected_db, 1e-9);
}

TEST(SeaSound, ComesBackFromARougherSurfaceStrongerAndNeverMoreThanSent) {
  double last = 0.0;
  for (const double wind_m_s : {0.0, 2.0, 5.0, 10.0, 20.0, 40.0}) {
    for (const double sine : {0.01, 0.1, 0.5, 0.9, 1.0}) {
      const double share = surface_backscatter(sine, 260.0, wind_m_s);
      EXPECT_LE(share, sine * sine / std::numbers::pi);
      EXPECT_GE(share, 0.0);
    }
    EXPECT_GE(surface_backscatter(0.5, 260.0, wind_m_s), last);
    last = surface_backscatter(0.5, 260.0, wind_m_s);
  }
}

TEST(BeamPattern, HasHalfItsPowerAtHalfItsWidth) {
  const BeamPattern beam{0.1, 0.4};

  EXPECT_NEAR(beam_power(beam, 0.0, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(beam_power(beam, std::sin(0.05), 0.0), 0.5, 1e-5);
  EXPECT_NEAR(beam_power(beam, 0.0, std::sin(-0.2)), 0.5, 1e-5);
}

TEST(BeamPattern, NeverFallsBelowItsSideLobes) {
  const BeamPattern beam{0.1, 0.4, -30.0};

  for (double across = -1.0; across <= 1.0; across += 0.01) {
    EXPECT_GE(beam_power(beam, across, 0.0), 0.001 - 1e-12);
    EXPECT_LE(beam_power(beam, across, 0.3), 1.0);
  }
}

TEST(BeamPattern, HasTheAnglesThatIntegrationGives) {
  const BeamPattern beam{core::degrees_to_radians(3.0), core::degrees_to_radians(20.0), -90.0};
  double one_way = 0.0;
  double two_way = 0.0;
  constexpr double step = 0.004;
  for (double across = -1.0; across <= 1.0; across += step) {
    for (double up = -1.0; up <= 1.0; up += step) {
      if (across * across + up * up >= 0.95)
        continue;  // the grid cannot follow the solid angle at right angles
      const double solid_angle = step * step / std::sqrt(1.0 - across * across - up * up);
      const double power = beam_power(beam, across, up);
      one_way += power * solid_angle;
      two_way += power * power * solid_angle;
    }
  }

  EXPECT_NEAR(reverberation_angle_sr(beam) / two_way, 1.0, 0.03);
  EXPECT_NEAR(directivity_db(beam), 10.0 * std::log10(4.0 * std::numbers::pi / one_way), 0.3);
}

}  // namespace
}  // namespace floeplan::simulation::sea_sound_test

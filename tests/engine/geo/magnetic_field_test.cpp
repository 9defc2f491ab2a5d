#include "engine/geo/magnetic_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::geo::magnetic_field_test {
namespace {

/// The instant of a year with a fraction: 2026.5 is the middle of 2026.
core::UtcTime at_year(double year) {
  using namespace std::chrono;
  const auto first_of = [](int each) {
    return core::UtcTime{sys_days{std::chrono::year{each} / January / 1}};
  };
  const int whole = static_cast<int>(year);
  return first_of(whole) + (year - whole) * (first_of(whole + 1) - first_of(whole));
}

double circle_deg(double angle_deg) { return std::remainder(angle_deg, 360.0); }

double inclination_deg(const MagneticField& field) {
  return core::radians_to_degrees(std::atan2(field.down_nt, std::hypot(field.east_nt, field.north_nt)));
}

double total_nt(const MagneticField& field) {
  return std::hypot(field.east_nt, field.north_nt, field.down_nt);
}

struct Known {
  LonLat place;
  double height_km;
  double year;
  double declination_deg;
  double inclination_deg;
  double total_nt;
};

void PrintTo(const Known& known, std::ostream* out) {
  *out << known.place.lat_deg << " N " << known.place.lon_deg << " E " << known.year;
}

class KnownField : public testing::TestWithParam<Known> {};

TEST_P(KnownField, IsFoundToAHundredthOfADegree) {
  const Known& known = GetParam();

  const auto field =
      magnetic_field_at(known.place, at_year(known.year), core::Metres{1000.0 * known.height_km});

  ASSERT_TRUE(field);
  const double declination_deg = core::radians_to_degrees(std::atan2(field->east_nt, field->north_nt));
  EXPECT_NEAR(circle_deg(declination_deg - known.declination_deg), 0.0, 0.01);
  EXPECT_NEAR(inclination_deg(*field), known.inclination_deg, 0.01);
  EXPECT_NEAR(total_nt(*field), known.total_nt, 1.0);
}

// The first six are test values that came with WMM2025; all are those of pygeomag 1.1.0, an independent implementation.
INSTANTIATE_TEST_SUITE_P(All, KnownField,
                         testing::Values(Known{{0.0, 80.0}, 0.0, 2025.0, 1.2815, 83.2106, 55178.5},
                                         Known{{120.0, 0.0}, 0.0, 2025.0, -0.1583, -14.9306, 41064.3},
                                         Known{{240.0, -80.0}, 0.0, 2025.0, 68.7754, -72.0050, 54698.2},
                                         Known{{0.0, 80.0}, 100.0, 2025.0, 0.8520, 83.2594, 52964.9},
                                         Known{{0.0, 80.0}, 0.0, 2027.5, 2.5941, 83.2363, 55253.9},
                                         Known{{240.0, -80.0}, 0.0, 2027.5, 68.4861, -71.9172, 54474.2},
                                         Known{{-52.5, 69.2}, 0.0, 2026.9, -27.2225, 80.7853, 55520.7},
                                         Known{{-65.0, 73.0}, 0.0, 2026.9, -32.5616, 83.7787, 56329.1},
                                         Known{{10.0, 78.0}, 0.0, 2026.9, 8.7808, 82.2945, 55054.8},
                                         Known{{-51.0, 47.5}, 0.0, 2026.9, -16.0027, 65.8087, 50206.2},
                                         Known{{179.9, -65.0}, 0.0, 2012.5, 62.2027, -80.1089, 63381.1},
                                         Known{{-179.9, -65.0}, 0.0, 2017.25, 62.8124, -79.8803, 63100.7},
                                         Known{{179.9, 71.0}, 0.0, 2022.75, -0.1789, 79.5962, 57438.0},
                                         Known{{90.0, 60.0}, 5.0, 2011.0, 7.8328, 78.0088, 60817.5},
                                         Known{{-52.5, 69.2}, 0.0, 2012.0, -34.4620, 81.0725, 55649.9},
                                         Known{{-52.5, 69.2}, 0.0, 2018.0, -31.4123, 80.9726, 55533.9},
                                         Known{{-52.5, 69.2}, 0.0, 2021.5, -29.7072, 80.9155, 55553.9}));

TEST(Declination, HasTheErrorThatTheModelStates) {
  const auto disko_bay = declination_at({-52.5, 69.2}, at_year(2026.9));

  ASSERT_TRUE(disko_bay);
  EXPECT_NEAR(disko_bay->east_deg, -27.2, 0.1);
  EXPECT_NEAR(disko_bay->sigma_deg, std::hypot(0.26, 5417.0 / 8890.77), 1e-4);
}

TEST(Declination, IsNotToldOutsideTheYearsOfTheModel) {
  EXPECT_TRUE(declination_at({0.0, 60.0}, at_year(2010.0)));
  EXPECT_TRUE(declination_at({0.0, 60.0}, at_year(2030.0)));
  const core::Seconds hour{3600.0};
  EXPECT_FALSE(declination_at({0.0, 60.0}, at_year(2010.0) - hour));
  EXPECT_FALSE(declination_at({0.0, 60.0}, at_year(2030.0) + hour));
  for (const double never : {0.0, -1e300, 1e300, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_FALSE(declination_at({0.0, 60.0}, core::from_unix_seconds(never))) << never;
}

TEST(MagneticField, NeedsAPlace) {
  EXPECT_THROW((void)magnetic_field_at({0.0, 91.0}, at_year(2026.0)), std::invalid_argument);
  EXPECT_THROW((void)declination_at({std::nan(""), 0.0}, at_year(2026.0)), std::invalid_argument);
}

TEST(Declination, StepsByLittleMoreThanItsErrorFromEditionToEdition) {
  support::for_each_seed(2000, [](std::mt19937_64& rng) {
    const LonLat place{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -89.0, 89.0)};
    const double change = 2010.0 + 5.0 * support::uniform_int(rng, 1, 3);

    const auto before = declination_at(place, at_year(change) - core::Seconds{1.0});
    const auto after = declination_at(place, at_year(change));

    ASSERT_TRUE(before && after);
    const double step_deg = std::abs(circle_deg(after->east_deg - before->east_deg));
    EXPECT_LE(step_deg, 1.5 * std::max(before->sigma_deg, after->sigma_deg));
  });
}

TEST(MagneticField, IsSmoothInPlaceAndTimeWithinAnEdition) {
  support::for_each_seed(2000, [](std::mt19937_64& rng) {
    const LonLat place{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -88.0, 88.0)};
    const auto time =
        at_year(2010.0 + 5.0 * support::uniform_int(rng, 0, 3) + support::uniform(rng, 0.0, 4.9));
    const LonLat beside{wrap_longitude(place.lon_deg + 0.01), place.lat_deg + 0.01};

    const auto here = magnetic_field_at(place, time);
    const auto there = magnetic_field_at(beside, time);
    const auto next_month = magnetic_field_at(place, time + core::Seconds{30.0 * 86'400.0});

    ASSERT_TRUE(here && there && next_month);
    // The field changes by at most some 20 nT a kilometre and 200 nT a year; the axes turn by 0.01 degrees.
    for (const auto& [near, most_nt] : {std::pair{*there, 60.0}, std::pair{*next_month, 30.0}}) {
      EXPECT_NEAR(near.east_nt, here->east_nt, most_nt);
      EXPECT_NEAR(near.north_nt, here->north_nt, most_nt);
      EXPECT_NEAR(near.down_nt, here->down_nt, most_nt);
    }
  });
}

TEST(MagneticField, IsOneAtThePoleHoweverItsLongitudeIsCalled) {
  for (const double lat_deg : {90.0, -90.0}) {
    const auto reference = magnetic_field_at({0.0, lat_deg}, at_year(2026.0));
    for (double lon_deg = -180.0; lon_deg < 180.0; lon_deg += 30.0) {
      const auto field = magnetic_field_at({lon_deg, lat_deg}, at_year(2026.0));
      ASSERT_TRUE(field && reference);
      EXPECT_NEAR(field->down_nt, reference->down_nt, 1e-6);
      // North along the meridian L bears L from that along the meridian 0, seen from above the north pole.
      const double turn_deg = core::radians_to_degrees(std::atan2(field->east_nt, field->north_nt) -
                                                       std::atan2(reference->east_nt, reference->north_nt));
      EXPECT_NEAR(circle_deg(turn_deg - (lat_deg > 0.0 ? lon_deg : -lon_deg)), 0.0, 1e-6) << lon_deg;
    }
  }
}

TEST(MagneticField, IsTheSameOnBothSidesOfTheAntimeridianAndUnderBothNamesOfALongitude) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const double lat_deg = support::uniform(rng, -89.0, 89.0);
    const auto time = at_year(support::uniform(rng, 2010.0, 2030.0));
    const auto west = magnetic_field_at({-180.0, lat_deg}, time);
    const auto east = magnetic_field_at({180.0, lat_deg}, time);
    const double lon_deg = support::uniform(rng, -180.0, 0.0);
    const auto negative = magnetic_field_at({lon_deg, lat_deg}, time);
    const auto positive = magnetic_field_at({lon_deg + 360.0, lat_deg}, time);

    ASSERT_TRUE(west && east && negative && positive);
    EXPECT_NEAR(west->east_nt, east->east_nt, 1e-6);
    EXPECT_NEAR(west->north_nt, east->north_nt, 1e-6);
    EXPECT_NEAR(negative->east_nt, positive->east_nt, 1e-6);
  });
}

}  // namespace
}  // namespace floeplan::geo::magnetic_field_test

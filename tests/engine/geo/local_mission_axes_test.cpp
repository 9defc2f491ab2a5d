#include "engine/geo/local_mission_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <stdexcept>

#include "engine/geo/geodesic.hpp"
#include "tests/support/property.hpp"

namespace floeplan::geo::local_mission_axes_test {
namespace {

core::Radians west(double variation_deg) { return {core::degrees_to_radians(variation_deg)}; }

TEST(LocalMissionAxes, TurnTheCurrentOfDiskoBay) {
  const LonLat place{-52.5, 69.2};
  const LocalMissionAxes axes{utm_zone_of(place), {0.4750}};

  const VelocityEn current = axes.to_true({{0.0}, {0.20}}, place);

  EXPECT_EQ(axes.utm_zone(), 22);
  EXPECT_NEAR(current.east.value, -0.0958, 1e-4);
  EXPECT_NEAR(current.north.value, 0.1756, 1e-4);
}

struct Known {
  LonLat place;
  int utm_zone;
  double convergence_deg;
};

void PrintTo(const Known& known, std::ostream* out) {
  *out << known.place.lat_deg << " N " << known.place.lon_deg << " E in zone " << known.utm_zone;
}

class KnownConvergence : public testing::TestWithParam<Known> {};

TEST_P(KnownConvergence, TurnsTheAxesClockwiseEastOfTheMeridianInTheNorth) {
  const Known& known = GetParam();

  const LocalMissionAxes axes{known.utm_zone, west(0.0)};

  EXPECT_NEAR(core::radians_to_degrees(axes.turn_at(known.place).value), -known.convergence_deg, 1e-8);
}

// Meridian convergence of proj 9 (tmerc on WGS84).
INSTANTIATE_TEST_SUITE_P(
    All, KnownConvergence,
    testing::Values(Known{{-52.5, 69.2}, 22, -1.4022790118255382}, Known{{5.9, 78.0}, 31, 2.836732797103024},
                    Known{{5.9, 78.0}, 32, -3.0323855116139353}, Known{{7.4, 54.3}, 32, -1.2994494467406545},
                    Known{{15.0, 60.0}, 31, 10.43039574706782}, Known{{179.9, 71.0}, 60, 2.742252501908467},
                    Known{{-179.9, 71.0}, 60, 2.9314112721897527},
                    Known{{179.9, -65.0}, 60, -2.628694799860493},
                    Known{{-179.9, -65.0}, 1, 2.628694799855535}));

TEST(LocalMissionAxes, AreUndoneByTheirInverseAndKeepTheSpeed) {
  support::for_each_seed(1000, [](std::mt19937_64& rng) {
    const LonLat place{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -85.0, 85.0)};
    const LocalMissionAxes axes{utm_zone_of(place), west(support::uniform(rng, -180.0, 180.0))};
    const VelocityLmc logged{{support::uniform(rng, -1.0, 1.0)}, {support::uniform(rng, -1.0, 1.0)}};

    const VelocityEn current = axes.to_true(logged, place);
    const VelocityLmc back = axes.to_lmc(current, place);

    EXPECT_NEAR(back.x.value, logged.x.value, 1e-14);
    EXPECT_NEAR(back.y.value, logged.y.value, 1e-14);
    EXPECT_NEAR(strength(current).value, std::hypot(logged.x.value, logged.y.value), 1e-14);
  });
}

/// Along the zone's own meridian the grid's north is true, so y points to magnetic north.
TEST(LocalMissionAxes, PointToMagneticNorthOnTheCentralMeridian) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const int zone = support::uniform_int(rng, 1, 60);
    const LonLat place{-183.0 + 6.0 * zone, support::uniform(rng, -85.0, 85.0)};
    const double declination_deg = support::uniform(rng, -179.0, 179.0);

    const VelocityEn y = LocalMissionAxes{zone, west(-declination_deg)}.to_true({{0.0}, {1.0}}, place);

    EXPECT_NEAR(core::radians_to_degrees(std::atan2(y.east.value, y.north.value)), declination_deg, 1e-9);
  });
}

/// On the grid a short geodesic is straight: its true course changes as grid north does.
TEST(LocalMissionAxes, TurnAlongAStraightWayAsItsCourseDoes) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const LonLat place{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -80.0, 80.0)};
    const LocalMissionAxes axes{utm_zone_of(place), west(20.0)};
    const LonLat beside = geodesic_destination(place, Bearing::degrees(90.0), core::Metres{1000.0});
    const GeodesicLine line = geodesic_between(place, beside);

    const double of_course =
        core::degrees_to_radians(line.course_at_end.degrees() - line.course_at_start.degrees());
    const double of_axes = axes.turn_at(place).value - axes.turn_at(beside).value;

    EXPECT_NEAR(of_axes, of_course, 1e-3 * std::abs(of_course) + 1e-5);
  });
}

TEST(UtmZone, IsSixDegreesWideFromTheAntimeridianOn) {
  EXPECT_EQ(utm_zone_of({-180.0, 10.0}), 1);
  EXPECT_EQ(utm_zone_of({180.0, 10.0}), 1);
  EXPECT_EQ(utm_zone_of({179.9, -65.0}), 60);
  EXPECT_EQ(utm_zone_of({-52.5, 69.2}), 22);
  EXPECT_EQ(utm_zone_of({307.5, 69.2}), 22);
  EXPECT_EQ(utm_zone_of({10.0, 78.0}), 32);
  EXPECT_EQ(standard_utm_zone_of({10.0, 78.0}), 33);
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const LonLat place{support::uniform(rng, -180.0, 180.0), support::uniform(rng, -79.0, 55.0)};
    EXPECT_EQ(utm_zone_of(place), standard_utm_zone_of(place));
    EXPECT_LE(std::abs(longitude_difference(-183.0 + 6.0 * utm_zone_of(place), place.lon_deg)), 3.0);
  });
}

TEST(LocalMissionAxes, NeedAZoneAndAVariation) {
  EXPECT_THROW((LocalMissionAxes{0, west(1.0)}), std::invalid_argument);
  EXPECT_THROW((LocalMissionAxes{61, west(1.0)}), std::invalid_argument);
  EXPECT_THROW((LocalMissionAxes{1, west(std::nan(""))}), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::geo::local_mission_axes_test

#include "engine/mission/writing/shoals.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/geo/geodesic.hpp"
#include "tests/engine/mission/random_plan.hpp"

namespace floeplan::mission::shoals_test {
namespace {

using support::plan_of;

constexpr double step_deg = 0.02;

/// A bathymetry from 54 W to 52 W and from 68.8 N to 69.4 N, 300 m deep except where `bed_m` gives another depth.
template <class Bed>
ocean::Bathymetry bed(const Bed& bed_m) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i <= 100; ++i) x.push_back(-54.0 + step_deg * i);
  for (int i = 0; i <= 30; ++i) y.push_back(68.8 + step_deg * i);
  std::vector<float> depth_m;
  for (const double lat : y)
    for (const double lon : x) depth_m.push_back(static_cast<float>(bed_m(geo::LonLat{lon, lat})));
  return {ocean::HorizontalGrid{geo::GeographicFrame{}, ocean::Axis{x}, ocean::Axis{y}}, depth_m};
}

TEST(Shoals, AreFoundBetweenTheWaypoints) {
  const auto bank =
      bed([](geo::LonLat place) { return std::abs(place.lon_deg + 53.0) < 0.03 ? 45.0 : 300.0; });
  const planning::Plan plan = plan_of({{-53.6, 69.1}, {-53.4, 69.1}, {-52.4, 69.1}, {-52.2, 69.1}});

  const auto shoals = shoals_along(bank, plan);

  ASSERT_EQ(shoals.size(), 4U);
  EXPECT_FALSE(shoals[0].has_value());
  EXPECT_EQ(shoals[1]->bed.value, 300.0);
  EXPECT_EQ(shoals[2]->bed.value, 45.0);
  EXPECT_NEAR(shoals[2]->place.lon_deg, -53.0, 0.04);
  EXPECT_EQ(shoals[3]->bed.value, 300.0);
  EXPECT_EQ(shoalest_of(plan, shoals)->waypoint, 2U);
}

TEST(Shoals, AreNotKnownBeyondTheData) {
  const auto flat = bed([](geo::LonLat) { return 300.0; });
  const auto shoals = shoals_along(flat, plan_of({{-50.0, 69.1}, {-49.0, 69.1}}));

  EXPECT_FALSE(shoals[1].has_value());
}

TEST(Shoals, CountTheDepthsThatThePlanKeeps) {
  planning::Plan plan = plan_of({{-53.6, 69.1}, {-53.4, 69.1}});
  EXPECT_FALSE(shoalest_of(plan, {}).has_value());
  plan.waypoints[0].depth = core::Metres{31.0};

  EXPECT_EQ(shoalest_of(plan, {})->bed.value, 31.0);
  EXPECT_EQ(shoalest_of(plan, {})->waypoint, 1U) << "the leg that it begins";
}

TEST(Shoals, OfAnyLegAreNoDeeperThanTheBedAnywhereOnIt) {
  support::for_each_seed(40, [](std::mt19937_64& rng) {
    const double phase = support::uniform(rng, 0.0, 6.0);
    const auto rough = bed([&](geo::LonLat place) {
      return 150.0 + 60.0 * std::sin(40.0 * place.lon_deg + phase) + 60.0 * std::cos(70.0 * place.lat_deg);
    });
    const auto place = [&] {
      return geo::LonLat{support::uniform(rng, -53.9, -52.1), support::uniform(rng, 68.85, 69.35)};
    };
    const planning::Plan plan = plan_of({place(), place()});

    const auto shoal = shoals_along(rough, plan).at(1);

    ASSERT_TRUE(shoal.has_value());
    const auto leg = geo::geodesic_between(plan.waypoints[0].place, plan.waypoints[1].place);
    for (int i = 0; i < 200; ++i) {
      const core::Metres along{support::uniform(rng, 0.0, leg.length.value)};
      const auto here =
          rough.shoalest(geo::geodesic_destination(plan.waypoints[0].place, leg.course_at_start, along));
      // The slope of the bed is less than 0.2, so between two samples 25 m apart it rises by less than 3 m.
      EXPECT_GT(here->value, shoal->bed.value - 3.0);
    }
  });
}

}  // namespace
}  // namespace floeplan::mission::shoals_test

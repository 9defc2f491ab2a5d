#include "engine/simulation/world/make_world.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "engine/planning/ice/ice_covers.hpp"
#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::simulation::make_world_test {
namespace {

constexpr core::UtcTime begin = core::from_unix_seconds(support::sea_start_s);
constexpr core::UtcTime end = begin + core::Seconds{6.0 * 3600.0};
constexpr std::array<geo::LonLat, 2> route{geo::LonLat{-53.0, 69.0}, geo::LonLat{-52.8, 69.0}};

ocean::Environment sea() {
  ocean::Environment environment;
  environment.currents =
      support::currents_from([](geo::LonLat, double) { return geo::VelocityEn{{0.1}, {0.0}}; }, 12);
  environment.bathymetry = support::bathymetry_from([](geo::LonLat) { return 300.0; });
  for (const auto& [id, place] :
       {std::pair{"near", geo::LonLat{-52.9, 69.02}}, {"far", geo::LonLat{-50.5, 70.2}}}) {
    ocean::Iceberg berg;
    berg.id = id;
    berg.place = place;
    berg.observed = begin;
    berg.length = core::Metres{80.0};
    environment.icebergs.push_back(berg);
  }
  return environment;
}

/// Law: the world has open water, and ice as deep, as the rules of the simulated plan say.
TEST(MakeWorld, HasIceWhereAPlanByTheSameRulesMayNotSurface) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    ocean::Environment icy = sea();
    const double shift = support::uniform(rng, 0.0, 1.0);
    icy.ice = support::ice_from(
        [&](geo::LonLat p, double) { return 0.5 + 0.5 * std::sin(40.0 * p.lon_deg + 9.0 * shift); }, {0.0},
        1.0);
    WorldSettings settings;
    settings.ice.max_concentration_to_surface = support::uniform(rng, 0.05, 0.95);
    const World world = make_world(icy, route, begin, end, settings, 1);
    const planning::plane::PlaneBox around{{-20e3, -20e3}, {20e3, 20e3}};
    const planning::ice::IceCovers plans{icy, settings.ice, world.projection(), around, begin};

    for (int i = 0; i < 20; ++i) {
      const geo::PlanePoint place{support::uniform(rng, -9e3, 9e3), support::uniform(rng, -9e3, 9e3)};
      const planning::ice::IceAbove above = plans.above(place, core::Seconds{0.0});
      EXPECT_EQ(world.ice_draft_m(place.x_m, place.y_m, begin) > 0.0, !above.may_surface);
    }
  });
}

TEST(MakeWorld, AgreesWithTheDataWhereNoErrorIsAskedFor) {
  const World world = make_world(sea(), route, begin, end, {}, 1);
  const Vector place = world.to_frame(route[1]);

  EXPECT_NEAR(world.bed_depth_m(place.east, place.north).value(), 300.0, 1e-3);
  EXPECT_NEAR(length(world.current(place, begin).value()), 0.1, 1e-3);
  ASSERT_EQ(world.bodies().size(), 1U);
  EXPECT_EQ(world.bodies().front().name(), "near");
}

TEST(MakeWorld, LetsIcebergsDriftWithTheWaterAndItsError) {
  const World forecast = make_world(sea(), route, begin, end, {}, 1);
  const World real = make_world(sea(), route, begin, end, {.current_error = {.rms = {0.1}}}, 1);

  const BodyPose there = forecast.bodies().front().pose_at(end);
  const BodyPose before = forecast.bodies().front().pose_at(begin);
  EXPECT_NEAR(std::hypot(there.east_m - before.east_m, there.north_m - before.north_m), 0.1 * 6.0 * 3600.0,
              30.0);
  const BodyPose strayed = real.bodies().front().pose_at(end);
  const double off_m = std::hypot(strayed.east_m - there.east_m, strayed.north_m - there.north_m);
  EXPECT_GT(off_m, 50.0);
  EXPECT_LT(off_m, 0.5 * 6.0 * 3600.0);
  EXPECT_EQ(real.bodies().front().pose_at(begin).east_m, before.east_m);
}

TEST(MakeWorld, IsTheSameForTheSameSeed) {
  const WorldSettings settings{.current_error = {.rms = {0.1}}};
  const World a = make_world(sea(), route, begin, end, settings, 7);
  const World b = make_world(sea(), route, begin, end, settings, 7);

  EXPECT_EQ(a.bodies().front().pose_at(end).east_m, b.bodies().front().pose_at(end).east_m);
  EXPECT_EQ(a.bodies().front().shape().draft_m, b.bodies().front().shape().draft_m);
  EXPECT_EQ(a.current({100.0, 200.0, 30.0}, begin), b.current({100.0, 200.0, 30.0}, begin));
}

TEST(MakeWorld, KnowsNothingBeyondItsMargin) {
  const World world = make_world(sea(), route, begin, end, {.margin = {5000.0}}, 1);

  EXPECT_FALSE(world.bed_depth_m(-9000.0, 0.0).has_value());
  EXPECT_FALSE(world.covers({-9000.0, 0.0, 0.0}, begin));
}

TEST(MakeWorld, RefusesSettingsOutOfRange) {
  EXPECT_THROW(static_cast<void>(make_world(sea(), {}, begin, end, {}, 1)), std::invalid_argument);
  EXPECT_EQ((WorldSettings{.most_spin_deg_h = -1.0, .margin = {0.0}}).violations().size(), 2U);
}

}  // namespace
}  // namespace floeplan::simulation::make_world_test

#include "engine/simulation/world/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/support/property.hpp"

namespace floeplan::simulation::world_test {
namespace {

using support::for_each_seed;
using support::uniform;

constexpr core::UtcTime begin = core::from_unix_seconds(1.7e9);
constexpr geo::LonLat origin{-52.0, 47.5};

Shape cube(double half_m) {
  return {.parts = {ConvexPart{{{{1.0, 0.0, 0.0}, half_m},
                                {{-1.0, 0.0, 0.0}, half_m},
                                {{0.0, 1.0, 0.0}, half_m},
                                {{0.0, -1.0, 0.0}, half_m},
                                {{0.0, 0.0, 1.0}, half_m},
                                {{0.0, 0.0, -1.0}, half_m}}}},
          .radius_m = 1.5 * half_m,
          .draft_m = half_m};
}

World field_of_bodies(std::mt19937_64& rng) {
  WorldParts parts{.origin = origin};
  for (int i = 0; i < 40; ++i) {
    const double east_m = uniform(rng, -3000.0, 3000.0);
    const double north_m = uniform(rng, -3000.0, 3000.0);
    parts.bodies.emplace_back(
        std::to_string(i), cube(20.0),
        Body::Motion{.track = {{begin, east_m, north_m},
                               {begin + core::Seconds{7200.0}, east_m + uniform(rng, -1500.0, 1500.0),
                                north_m + uniform(rng, -1500.0, 1500.0)}}});
  }
  return World{std::move(parts)};
}

/// Currents of 0.1 m/s at the surface and 0.3 m/s at 100 m, with no water below 50 m at the easternmost node.
std::shared_ptr<const ocean::CurrentGrid> sheared() {
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, ocean::Axis{{-53.0, -52.0, -51.0}},
                                   ocean::Axis{{47.0, 48.0}}};
  std::vector<float> u;
  for (const float speed : {0.1F, 0.2F, 0.3F}) {
    for (int i = 0; i < 6; ++i) u.push_back(speed == 0.3F && i % 3 == 2 ? std::nanf("") : speed);
  }
  const std::vector<float> v(u.size(), 0.0F);
  return std::make_shared<ocean::CurrentGrid>(ocean::CurrentGrid::Samples{
      grid, ocean::Axis{{0.0, 50.0, 100.0}}, ocean::Axis{{core::unix_seconds(begin)}}, u, v});
}

TEST(World, GoesToTheFrameAndBack) {
  const World world{{.origin = origin}};
  for_each_seed(50, [&](std::mt19937_64& rng) {
    const Vector place{uniform(rng, -5e4, 5e4), uniform(rng, -5e4, 5e4), 0.0};

    const Vector back = world.to_frame(world.to_lon_lat(place));

    EXPECT_NEAR(back.east, place.east, 1e-6);
    EXPECT_NEAR(back.north, place.north, 1e-6);
  });
}

TEST(World, FlowsAsTheForecastWhereThatIsTrue) {
  const geo::LocalProjection projection{origin};
  const World world{{.origin = origin, .current = TrueCurrent{{sheared(), true}, projection, {}}}};

  EXPECT_NEAR(world.current({0.0, 0.0, 75.0}, begin)->east, 0.25, 1e-6);
  EXPECT_NEAR(world.current({0.0, 0.0, 500.0}, begin)->east, 0.3, 1e-6);
  // Without water at 100 m beside it, the deepest level with water all around.
  EXPECT_NEAR(length(*world.current(world.to_frame({-51.2, 47.5}, 100.0), begin)), 0.2, 1e-3);
  // Two cells off the water as plans extend it, and no farther.
  EXPECT_NEAR(world.current(world.to_frame({-49.3, 47.5}), begin)->east, 0.1, 1e-2);
  EXPECT_FALSE(world.current(world.to_frame({-48.3, 47.5}), begin).has_value());
  EXPECT_FALSE(world.current(world.to_frame({-30.0, 47.5}), begin).has_value());
  EXPECT_FALSE(world.covers(world.to_frame({-30.0, 47.5}), begin));
}

TEST(World, AddsTheErrorToTheForecast) {
  const CurrentErrorField error{{.rms = {0.1}}, begin, 1};
  const World world{{.origin = origin, .current = TrueCurrent{{0.2, 0.1, 0.0}, error}}};
  const Vector place{4000.0, -2000.0, 30.0};

  EXPECT_EQ(*world.current(place, begin), (Vector{0.2, 0.1, 0.0}) + error.at(place, begin));
}

TEST(NearbyBodies, MissNoneThatIsWithinReach) {
  for_each_seed(20, [](std::mt19937_64& rng) {
    const World world = field_of_bodies(rng);
    NearbyBodies near{world, {200.0}};
    Vector place{uniform(rng, -2000.0, 2000.0), uniform(rng, -2000.0, 2000.0), 10.0};
    for (core::UtcTime time = begin; time < begin + core::Seconds{3600.0}; time += core::Seconds{20.0}) {
      place = place + Vector{uniform(rng, -40.0, 40.0), uniform(rng, -40.0, 40.0), 0.0};

      const auto found = near.at(place, time);

      for (std::uint32_t i = 0; i < world.bodies().size(); ++i) {
        const Body& body = world.bodies()[i];
        if (body.distance(body.pose_at(time), place) > 200.0) continue;
        EXPECT_TRUE(std::ranges::any_of(found, [&](const auto& posed) { return posed.index == i; }));
      }
    }
  });
}

TEST(World, HasABedAndACeilingWhereTheyAreGiven) {
  const World world{
      {.origin = origin, .bed = SeaBed{core::Metres{120.0}}, .ice = IceLayer{core::Metres{3.0}}}};

  EXPECT_EQ(world.bed_depth_m(10.0, 20.0), 120.0);
  EXPECT_EQ(world.ice_draft_m(10.0, 20.0, begin), 3.0);
  EXPECT_FALSE(World{{.origin = origin}}.bed_depth_m(0.0, 0.0).has_value());
}

}  // namespace
}  // namespace floeplan::simulation::world_test

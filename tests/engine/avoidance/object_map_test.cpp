#include "engine/avoidance/object_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "engine/core/random.hpp"
#include "tests/support/property.hpp"

namespace floeplan::avoidance::object_map_test {
namespace {

/// A round upright berg, seen from the south by a vehicle that swims past it.
struct Berg {
  double radius_m{50.0};
  geo::PlanePoint start{0.0, 150.0};
  geo::PlaneVelocity drift{};

  [[nodiscard]] geo::PlanePoint centre(double time_s) const {
    return {start.x_m + time_s * drift.x_m_s, start.y_m + time_s * drift.y_m_s};
  }
};

/// Echoes of its near side, 3 degrees apart, at two depths, with a metre of noise.
std::vector<Echo> seen(const Berg& berg, geo::PlanePoint from, double time_s, std::mt19937_64& rng) {
  std::vector<Echo> ping;
  const geo::PlanePoint centre = berg.centre(time_s);
  for (double bearing = 0.0; bearing < 2.0 * std::numbers::pi; bearing += core::degrees_to_radians(3.0)) {
    const double ex = std::sin(bearing);
    const double ey = std::cos(bearing);
    const double along = (centre.x_m - from.x_m) * ex + (centre.y_m - from.y_m) * ey;
    const double across = (centre.x_m - from.x_m) * ey - (centre.y_m - from.y_m) * ex;
    if (along < 0.0 || std::abs(across) > berg.radius_m) continue;
    const double range =
        along - std::sqrt(berg.radius_m * berg.radius_m - across * across) + core::normal(rng);
    if (range > 200.0) continue;
    for (const double depth : {12.0, 25.0})
      ping.push_back({{from.x_m + range * ex, from.y_m + range * ey}, depth, range});
  }
  return ping;
}

/// The map after the vehicle has swum east past the berg for a while.
std::unique_ptr<ObjectMap> map_after(double seconds, const Berg& berg, std::mt19937_64& rng) {
  auto map = std::make_unique<ObjectMap>(AvoidanceSettings{});
  OwnState own;
  own.depth = core::Metres{20.0};
  for (double t = 0.0; t <= seconds; t += 1.0) {
    const geo::PlanePoint from{-60.0 + 0.35 * t, 0.0};
    map->advance(t);
    map->take(seen(berg, from, t, rng), own, from);
  }
  return map;
}

TEST(ObjectMap, MakesOneObjectOfOneBody) {
  auto rng = core::random_stream(1, "map");
  const auto map = map_after(60.0, Berg{}, rng);
  ASSERT_EQ(map->size(), 1U);
  EXPECT_GT((*map)[0].half_extent_m(), 25.0);
  EXPECT_LT((*map)[0].half_extent_m(), 75.0);
  EXPECT_NEAR((*map)[0].keel_m(), 25.0, 1.0);
}

/// The top of a scarp looks like ice that reaches down to the part of the scarp that counts as sea bed.
TEST(ObjectMap, LooksBelowNothingThatStandsOnTheSeaBed) {
  auto rng = core::random_stream(1, "map");
  const auto map = map_after(60.0, Berg{}, rng);
  ASSERT_GE((*map)[0].looks_below(), 20);
  const geo::PlanePoint beside = (*map)[0].place((*map)[0].cell(0));

  map->stand_on({beside, 80.0, 100.0, 70.0, 90.0});  // far below the keel
  EXPECT_GE((*map)[0].looks_below(), 20);
  map->stand_on({{beside.x_m, beside.y_m - 60.0}, 34.0, 100.0, 28.0, 40.0});
  EXPECT_GE((*map)[0].looks_below(), 20);

  map->stand_on({beside, 34.0, 100.0, 28.0, 40.0});
  EXPECT_EQ((*map)[0].looks_below(), 0);
}

/// Every patch lies on the true surface, as it has moved.
TEST(ObjectMap, KeepsTheSurfaceWhereTheBodyHasDriftedTo) {
  const Berg berg{.drift = {-0.1, -0.05}};
  support::for_each_seed(5, [&](std::mt19937_64& rng) {
    const auto map = map_after(240.0, berg, rng);
    ASSERT_EQ(map->size(), 1U);
    const geo::PlanePoint centre = berg.centre(240.0);
    for (std::size_t i = 0; i < (*map)[0].size(); ++i) {
      const geo::PlanePoint patch = (*map)[0].place((*map)[0].cell(i));
      EXPECT_NEAR(std::hypot(patch.x_m - centre.x_m, patch.y_m - centre.y_m), berg.radius_m, 12.0);
    }
  });
}

TEST(ObjectMap, LearnsTheDrift) {
  support::for_each_seed(10, [](std::mt19937_64& rng) {
    const double towards = 2.0 * std::numbers::pi * core::uniform(rng);
    const Berg berg{.drift = {0.15 * std::sin(towards), 0.15 * std::cos(towards)}};
    const auto map = map_after(200.0, berg, rng);
    ASSERT_GE(map->size(), 1U);
    const geo::PlaneVelocity found = (*map)[0].drift();
    EXPECT_NEAR(found.x_m_s, berg.drift.x_m_s, 0.05);
    EXPECT_NEAR(found.y_m_s, berg.drift.y_m_s, 0.05);
    EXPECT_LT((*map)[0].drift_sigma_m_s(), 0.05);
  });
}

TEST(ObjectMap, KnowsLessOfWhatItNoLongerSees) {
  auto rng = core::random_stream(2, "map");
  const auto map = map_after(60.0, Berg{}, rng);
  const double seen_sigma_m = (*map)[0].place_sigma_m();
  map->advance(360.0);
  EXPECT_GT((*map)[0].place_sigma_m(), seen_sigma_m + 300.0 * 0.5 * (*map)[0].drift_sigma_m_s());
  map->advance(60.0 + AvoidanceSettings{}.forget.count() + 1.0);
  EXPECT_EQ(map->size(), 0U);
}

/// More bodies than the map can hold: it keeps its size and the bodies seen last.
TEST(ObjectMap, LetsTheOldestGiveWayWhenItIsFull) {
  const auto map = std::make_unique<ObjectMap>(AvoidanceSettings{});
  OwnState own;
  double t = 0.0;
  for (int body = 0; body < 40; ++body) {
    const std::vector<Echo> ping{{{200.0 * body, 0.0}, 10.0, 100.0}};
    for (int i = 0; i < 4; ++i) {
      map->advance(++t);
      map->take(ping, own, {200.0 * body, -100.0});
    }
  }
  EXPECT_EQ(map->size(), ObjectMap::most_objects);
  double newest = 0.0;
  for (std::size_t i = 0; i < map->size(); ++i) newest = std::max(newest, (*map)[i].centre().x_m);
  EXPECT_NEAR(newest, 200.0 * 39, 1.0);
}

}  // namespace
}  // namespace floeplan::avoidance::object_map_test

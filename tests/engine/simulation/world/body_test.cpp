#include "engine/simulation/world/body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::simulation::body_test {
namespace {

using support::for_each_seed;
using support::uniform;

constexpr core::UtcTime begin = core::from_unix_seconds(1.7e9);

ConvexPart box(double along_m, double across_m, double draft_m, double offset_across_m = 0.0) {
  return ConvexPart{{{{1.0, 0.0, 0.0}, 0.5 * along_m},
                     {{-1.0, 0.0, 0.0}, 0.5 * along_m},
                     {{0.0, 1.0, 0.0}, 0.5 * across_m + offset_across_m},
                     {{0.0, -1.0, 0.0}, 0.5 * across_m - offset_across_m},
                     {{0.0, 0.0, 1.0}, draft_m},
                     {{0.0, 0.0, -1.0}, 5.0}}};
}

Body long_berg(Body::Motion motion) {
  return Body{
      "long", {.parts = {box(100.0, 20.0, 30.0)}, .radius_m = 51.0, .draft_m = 30.0}, std::move(motion)};
}

TEST(Body, LiesAlongItsHeading) {
  const Body berg = long_berg({.track = {{begin, 1000.0, 2000.0}}, .heading_rad = 0.5 * std::numbers::pi});
  const BodyPose pose = berg.pose_at(begin);

  EXPECT_TRUE(berg.contains(pose, {1045.0, 2000.0, 10.0}));
  EXPECT_FALSE(berg.contains(pose, {1000.0, 2045.0, 10.0}));
  EXPECT_FALSE(berg.contains(pose, {1045.0, 2000.0, 31.0}));
}

TEST(Body, DriftsEvenlyBetweenItsFixesAndTurns) {
  const core::Seconds hour{3600.0};
  const Body berg = long_berg({.track = {{begin, 0.0, 0.0}, {begin + hour, 720.0, -360.0}},
                               .heading_rad = 0.0,
                               .spin_rad_s = 0.5 * std::numbers::pi / 3600.0});

  const BodyPose halfway = berg.pose_at(begin + 0.5 * hour);
  EXPECT_DOUBLE_EQ(halfway.east_m, 360.0);
  EXPECT_DOUBLE_EQ(halfway.north_m, -180.0);
  EXPECT_NEAR(halfway.sine, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(berg.velocity_at(begin + 0.5 * hour).east, 0.2, 1e-12);
  EXPECT_EQ(berg.pose_at(begin + 2.0 * hour).east_m, 720.0);
  EXPECT_EQ(berg.velocity_at(begin + 2.0 * hour), Vector{});
}

TEST(Body, NeverTakesAPointForFartherThanItIs) {
  const Body berg = long_berg({.track = {{begin, 0.0, 0.0}}, .heading_rad = 0.7});
  const BodyPose pose = berg.pose_at(begin);
  for_each_seed(300, [&](std::mt19937_64& rng) {
    const Vector point{uniform(rng, -300.0, 300.0), uniform(rng, -300.0, 300.0), uniform(rng, 0.0, 80.0)};

    EXPECT_LE(berg.least_distance(pose, point), berg.distance(pose, point) + 0.01);
    EXPECT_EQ(berg.contains(pose, point), berg.distance(pose, point) <= 0.0);
  });
}

TEST(Body, HasHollowsBetweenItsParts) {
  const Body dock{"dock",
                  {.parts = {box(100.0, 20.0, 30.0, -40.0), box(100.0, 20.0, 30.0, 40.0)},
                   .radius_m = 72.0,
                   .draft_m = 30.0},
                  {.track = {{begin, 0.0, 0.0}}}};
  const BodyPose pose = dock.pose_at(begin);

  EXPECT_FALSE(dock.contains(pose, {0.0, 0.0, 10.0}));
  EXPECT_NEAR(dock.distance(pose, {0.0, 0.0, 10.0}), 30.0, 0.01);
  const auto hit = dock.first_hit(pose, {0.0, 0.0, 10.0}, {-1.0, 0.0, 0.0}, 100.0);
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->range_m, 30.0, 1e-9);
  EXPECT_NEAR(hit->normal.east, 1.0, 1e-12);
  EXPECT_FALSE(dock.first_hit(pose, {0.0, 0.0, 10.0}, {-1.0, 0.0, 0.0}, 29.0).has_value());
}

TEST(Body, RefusesATrackThatGoesBackInTime) {
  EXPECT_THROW(long_berg({.track = {}}), std::invalid_argument);
  EXPECT_THROW(long_berg({.track = {{begin, 0.0, 0.0}, {begin, 1.0, 0.0}}}), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::simulation::body_test

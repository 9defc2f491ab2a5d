#include "engine/simulation/world/convex_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::simulation::convex_part_test {
namespace {

using support::for_each_seed;
using support::uniform;

/// A box of 40 x 20 x 10 m about the origin.
ConvexPart box() {
  return ConvexPart{{{{1.0, 0.0, 0.0}, 20.0},
                     {{-1.0, 0.0, 0.0}, 20.0},
                     {{0.0, 1.0, 0.0}, 10.0},
                     {{0.0, -1.0, 0.0}, 10.0},
                     {{0.0, 0.0, 1.0}, 5.0},
                     {{0.0, 0.0, -1.0}, 5.0}}};
}

double box_distance(BodyPoint p) {
  const double x = std::max(0.0, std::abs(p.along) - 20.0);
  const double y = std::max(0.0, std::abs(p.across) - 10.0);
  const double z = std::max(0.0, std::abs(p.down) - 5.0);
  return std::sqrt(x * x + y * y + z * z);
}

BodyPoint random_point(std::mt19937_64& rng, double reach_m) {
  return {uniform(rng, -reach_m, reach_m), uniform(rng, -reach_m, reach_m), uniform(rng, -reach_m, reach_m)};
}

TEST(ConvexPart, IsAsFarAsABoxIs) {
  const ConvexPart part = box();
  for_each_seed(500, [&](std::mt19937_64& rng) {
    const BodyPoint point = random_point(rng, 60.0);

    const double wanted_m = box_distance(point);

    EXPECT_EQ(part.contains(point), wanted_m == 0.0);
    EXPECT_LE(part.plane_distance(point), wanted_m + 1e-9);
    EXPECT_NEAR(std::max(0.0, part.distance(point)), wanted_m, 0.01);
  });
}

TEST(ConvexPart, IsNearestAtASharpEdgeToo) {
  const double s = std::sin(0.2);
  const double c = std::cos(0.2);
  const ConvexPart wedge{
      {{{s, c, 0.0}, 0.0}, {{s, -c, 0.0}, 0.0}, {{-1.0, 0.0, 0.0}, 100.0}, {{0.0, 0.0, 1.0}, 10.0}}};

  EXPECT_NEAR(wedge.distance({30.0, 5.0, 0.0}), std::hypot(30.0, 5.0), 0.01);
}

TEST(ConvexPart, IsMetByARayWhereTheRayEntersIt) {
  const ConvexPart part = box();
  for_each_seed(500, [&](std::mt19937_64& rng) {
    const BodyPoint from = random_point(rng, 60.0);
    const BodyPoint to = random_point(rng, 60.0);
    const double gap_m = std::sqrt(std::pow(to.along - from.along, 2) + std::pow(to.across - from.across, 2) +
                                   std::pow(to.down - from.down, 2));
    const BodyPoint direction{(to.along - from.along) / gap_m, (to.across - from.across) / gap_m,
                              (to.down - from.down) / gap_m};

    const auto hit = part.first_hit(from, direction, gap_m);

    const auto along_ray = [&](double range_m) {
      return BodyPoint{from.along + range_m * direction.along, from.across + range_m * direction.across,
                       from.down + range_m * direction.down};
    };
    bool crosses = false;
    for (double range_m = 0.0; range_m <= (hit ? hit->range_m - 0.01 : gap_m); range_m += 0.05) {
      crosses = crosses || part.plane_distance(along_ray(range_m)) < -0.01;
    }
    EXPECT_FALSE(crosses);
    if (hit) {
      EXPECT_LE(part.plane_distance(along_ray(hit->range_m)), 1e-9);
    }
    EXPECT_TRUE(hit.has_value() || !part.contains(to));
  });
}

TEST(ConvexPart, TurnsTheFaceThatWasHitToTheRay) {
  const auto hit = box().first_hit({-50.0, 3.0, 2.0}, {1.0, 0.0, 0.0}, 100.0);

  ASSERT_TRUE(hit.has_value());
  EXPECT_DOUBLE_EQ(hit->range_m, 30.0);
  EXPECT_EQ(hit->normal, (BodyPoint{-1.0, 0.0, 0.0}));
}

TEST(ConvexPart, RefusesFacesThatBoundNothing) {
  EXPECT_THROW(ConvexPart({{{1.0, 0.0, 0.0}, 1.0}}), std::invalid_argument);
  EXPECT_THROW(ConvexPart({{{1.0, 1.0, 0.0}, 1.0}, {{}, 1.0}, {{}, 1.0}, {{}, 1.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::simulation::convex_part_test

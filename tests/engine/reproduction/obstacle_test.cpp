#include "engine/reproduction/obstacle.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/property.hpp"

namespace floeplan::reproduction::obstacle_test {
namespace {

using geo::PlanePoint;

bool contains(const Obstacle& obstacle, PlanePoint p) {
  return p.x_m >= obstacle.low.x_m && p.x_m <= obstacle.high.x_m && p.y_m >= obstacle.low.y_m &&
         p.y_m <= obstacle.high.y_m;
}

PlanePoint random_point(std::mt19937_64& rng) {
  return {support::uniform(rng, -3.0, 3.0), support::uniform(rng, -3.0, 3.0)};
}

TEST(Obstacle, MeetsALineThatHasAPointInside) {
  support::for_each_seed(500, [](std::mt19937_64& rng) {
    const Obstacle obstacle{{-1.0, -0.5}, {1.5, 0.5}};
    const PlanePoint a = random_point(rng);
    const PlanePoint b = random_point(rng);
    bool inside = false;
    for (int i = 0; i <= 2000; ++i) {
      const double share = i / 2000.0;
      inside =
          inside || contains(obstacle, {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m)});
    }
    // Between two samples a line can nick a corner: a slightly smaller rectangle is then not met.
    const Obstacle smaller{{-0.99, -0.49}, {1.49, 0.49}};
    EXPECT_TRUE(!inside || obstacle.meets(a, b));
    EXPECT_TRUE(inside || !smaller.meets(a, b));
    EXPECT_EQ(obstacle.meets(a, b), obstacle.meets(b, a));
  });
}

TEST(Obstacle, MeetsAPointInsideAndLinesAlongItsSides) {
  const Obstacle obstacle{{0.0, 0.0}, {2.0, 1.0}};

  EXPECT_TRUE(obstacle.meets({1.0, 0.5}, {1.0, 0.5}));
  EXPECT_TRUE(obstacle.meets({-1.0, 1.0}, {3.0, 1.0}));
  EXPECT_FALSE(obstacle.meets({-1.0, 1.001}, {3.0, 1.001}));
  EXPECT_FALSE(obstacle.meets({3.0, 0.5}, {3.0, 0.5}));
}

}  // namespace
}  // namespace floeplan::reproduction::obstacle_test

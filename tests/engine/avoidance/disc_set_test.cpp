#include "engine/avoidance/disc_set.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "engine/avoidance/steering.hpp"
#include "tests/support/property.hpp"

namespace floeplan::avoidance::disc_set_test {
namespace {

constexpr double horizon_s = 600.0;

/// Patches of three objects, each with a drift of its own.
std::vector<Obstacle> any_field(std::mt19937_64& rng) {
  std::vector<Obstacle> field;
  for (int object = 0; object < 3; ++object) {
    const geo::PlanePoint about{support::uniform(rng, -300.0, 300.0), support::uniform(rng, -300.0, 300.0)};
    const geo::PlaneVelocity drift{support::uniform(rng, -0.2, 0.2), support::uniform(rng, -0.2, 0.2)};
    for (int patch = 0; patch < 20; ++patch) {
      field.push_back(
          {{about.x_m + support::uniform(rng, -60.0, 60.0), about.y_m + support::uniform(rng, -60.0, 60.0)},
           drift,
           5.0,
           support::uniform(rng, 0.0, 0.05),
           patch == 0});
    }
  }
  return field;
}

/// One obstacle after the other.
std::optional<double> slowly(const std::vector<Obstacle>& field, const LookAhead& look,
                             const motion::EvenMove& move) {
  std::optional<double> first;
  for (const Obstacle& obstacle : field) {
    if (obstacle.is_guess && !look.takes_guesses) continue;
    const auto touch =
        motion::first_touch(move, disc_of(obstacle, look.now_s, look.until_s, look.clearance_m));
    if (touch && (!first || *touch < *first)) first = touch;
  }
  return first;
}

/// Law: obstacles that the set skips, as a group or because they are out of reach, do not touch the vehicle.
TEST(DiscSet, FindsTheTouchThatEachObstacleByItselfWouldTell) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    std::vector<Obstacle> field = any_field(rng);
    std::erase_if(field, [](const Obstacle& o) { return geo::distance_m({}, o.centre) < 60.0; });
    const LookAhead look{.from = {},
                         .now_s = 0.0,
                         .until_s = horizon_s,
                         .clearance_m = 20.0,
                         .reach_m = 0.35 * horizon_s,
                         .takes_guesses = support::uniform(rng, 0.0, 1.0) < 0.5};
    const DiscSet discs{field, look};
    for (int k = 0; k < 36; ++k) {
      const motion::EvenMove move{{}, moved({}, 0.1745 * k, look.reach_m), 0.0, horizon_s};
      const auto slow = slowly(field, look, move);
      const auto quick = discs.first_touch(move);

      ASSERT_EQ(quick.has_value(), slow.has_value());
      if (slow) {
        EXPECT_DOUBLE_EQ(*quick, *slow);
      }
      EXPECT_EQ(discs.is_touched(move), slow.has_value());
    }
  });
}

TEST(DiscSet, LeavesOutsideWhoIsWithinADisc) {
  const std::vector<Obstacle> field{{{10.0, 0.0}, {}, 5.0, 0.0, false}};
  const DiscSet discs{field, {.from = {}, .now_s = 0.0, .until_s = 100.0, .clearance_m = 30.0}};

  EXPECT_FALSE(discs.is_touched({{}, {-50.0, 0.0}, 0.0, 100.0}));
  EXPECT_TRUE(discs.is_touched({{}, {50.0, 0.0}, 0.0, 100.0}));
}

}  // namespace
}  // namespace floeplan::avoidance::disc_set_test

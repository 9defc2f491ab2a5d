#include "engine/simulation/vehicle/dead_reckoning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/property.hpp"

namespace floeplan::simulation::dead_reckoning_test {
namespace {

constexpr core::UtcTime start = core::from_unix_seconds(1.7e9);
constexpr core::Seconds second{1.0};

TEST(DeadReckoning, DriftsInProportionToTheDistance) {
  const NavigationErrors errors{.compass = {0.04}, .speed_share = 0.05, .fix = {0.0}, .current = {0.0}};
  constexpr int runs = 4000;
  constexpr double speed_m_s = 0.3;
  double along = 0.0;
  double across = 0.0;
  double stated_m = 0.0;
  for (int seed = 1; seed <= runs; ++seed) {
    DeadReckoning reckoning{errors, {}, {}, true, static_cast<std::uint64_t>(seed)};
    reckoning.dive(start);
    for (int i = 0; i < 100; ++i) reckoning.advance(0.0, speed_m_s, 10.0 * second);
    along += std::pow(reckoning.place().north - 300.0, 2);
    across += std::pow(reckoning.place().east, 2);
    stated_m = reckoning.sigma_m(start + 1000.0 * second);
  }

  // Deviations of the two biases times the distance; their estimates are good to 1 / sqrt(2 runs).
  EXPECT_NEAR(std::sqrt(along / runs), 0.05 * 300.0, 0.6);
  EXPECT_NEAR(std::sqrt(across / runs), 0.04 * 300.0, 0.5);
  EXPECT_NEAR(stated_m, std::hypot(0.05, 0.04) * 300.0, 3.0);
}

TEST(DeadReckoning, FindsTheCurrentThatItWasNotToldOf) {
  const NavigationErrors none{.compass = {0.0}, .speed_share = 0.0, .fix = {0.0}, .current = {0.0}};
  const Vector water{0.11, -0.07, 0.0};
  DeadReckoning reckoning{none, {}, {0.02, 0.01, 0.0}, true, 1};
  Vector truth{};
  const auto drift = [&](double for_s) { truth = truth + for_s * water; };

  reckoning.dive(start);
  for (int i = 0; i < 3600; ++i) {
    reckoning.advance(1.0, 0.25, second);
    truth = truth + Vector{0.25 * std::sin(1.0), 0.25 * std::cos(1.0), 0.0};
    drift(1.0);
  }
  reckoning.surface(start + 3600.0 * second);
  drift(120.0);
  reckoning.fix(truth, start + 3720.0 * second);
  // The first estimate takes the drift at the surface for one under water.
  const Vector initial = reckoning.depth_averaged_current();
  EXPECT_NEAR(initial.east, 0.02 + (0.11 * 3720.0 - 0.02 * 3600.0) / 3600.0, 1e-9);
  drift(300.0);
  reckoning.fix(truth, start + 4020.0 * second);

  EXPECT_NEAR(reckoning.depth_averaged_current().east, water.east, 1e-9);
  EXPECT_NEAR(reckoning.depth_averaged_current().north, water.north, 1e-9);
  EXPECT_NEAR(reckoning.place().east, truth.east, 1e-9);
}

TEST(DeadReckoning, LeavesTheCurrentOutWhereTheMissionSaysSo) {
  DeadReckoning reckoning{{}, {}, {0.3, 0.0, 0.0}, false, 1};
  reckoning.dive(start);
  reckoning.advance(0.0, 0.0, 100.0 * second);

  EXPECT_EQ(reckoning.place(), Vector{});
  EXPECT_EQ(reckoning.assumed_current(), Vector{});
}

TEST(NavigationErrors, NameEveryValueOutOfRange) {
  EXPECT_TRUE(NavigationErrors{}.violations().empty());

  const NavigationErrors wrong{
      .compass = {-1.0}, .speed_share = 2.0, .fix = {std::nan("")}, .current = {-1.0}};
  EXPECT_EQ(wrong.violations().size(), 4U);
}

}  // namespace
}  // namespace floeplan::simulation::dead_reckoning_test

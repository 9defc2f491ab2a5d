#include "engine/simulation/world/current_error_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/property.hpp"

namespace floeplan::simulation::current_error_field_test {
namespace {

using support::for_each_seed;
using support::uniform;

constexpr core::UtcTime epoch = core::from_unix_seconds(1.7e9);
const CurrentErrorSettings settings{.rms = {0.1},
                                    .length_scale = {5000.0},
                                    .depth_scale = {100.0},
                                    .time_scale = core::Seconds{6.0 * 3600.0}};

/// Mean product of the components at two points over many fields, as a share of the variance.
struct Correlation {
  double along{};   // of the component along the distance
  double across{};  // of the one across it
};

Correlation correlation(Vector apart, core::Seconds later) {
  constexpr std::uint64_t fields = 4000;
  Correlation sum;
  for (std::uint64_t seed = 1; seed <= fields; ++seed) {
    const CurrentErrorField field{settings, epoch, seed};
    const Vector here = field.at({}, epoch);
    const Vector there = field.at(apart, epoch + later);
    sum.along += here.east * there.east;
    sum.across += here.north * there.north;
  }
  const double variance = settings.rms.value * settings.rms.value * fields;
  return {sum.along / variance, sum.across / variance};
}

TEST(CurrentErrorField, HasTheStatedSpeed) {
  const Correlation same = correlation({}, core::Seconds{0.0});

  EXPECT_NEAR(same.along, 1.0, 0.1);
  EXPECT_NEAR(same.across, 1.0, 0.1);
}

TEST(CurrentErrorField, ForgetsOverTheStatedScales) {
  // A stream function exp(-r^2 / 2 L^2): along the distance the flow falls like it, across it by a factor 1 - r^2/L^2
  // more.
  const double bell = std::exp(-0.5);
  const Correlation aside = correlation({settings.length_scale.value, 0.0, 0.0}, core::Seconds{0.0});
  EXPECT_NEAR(aside.along, bell, 0.1);
  EXPECT_NEAR(aside.across, 0.0, 0.1);
  EXPECT_NEAR(correlation({0.0, 0.0, settings.depth_scale.value}, core::Seconds{0.0}).along, bell, 0.1);
  EXPECT_NEAR(correlation({}, settings.time_scale).along, bell, 0.1);
}

TEST(CurrentErrorField, HasNoDivergence) {
  for_each_seed(50, [](std::mt19937_64& rng) {
    const CurrentErrorField field{settings, epoch, rng()};
    const Vector place{uniform(rng, -2e4, 2e4), uniform(rng, -2e4, 2e4), uniform(rng, 0.0, 200.0)};
    constexpr double step_m = 1.0;

    const double east = field.at(place + Vector{step_m, 0.0, 0.0}, epoch).east -
                        field.at(place - Vector{step_m, 0.0, 0.0}, epoch).east;
    const double north = field.at(place + Vector{0.0, step_m, 0.0}, epoch).north -
                         field.at(place - Vector{0.0, step_m, 0.0}, epoch).north;

    EXPECT_NEAR((east + north) / (2.0 * step_m), 0.0, 1e-10);
  });
}

TEST(CurrentErrorField, IsTheSameForTheSameSeed) {
  const CurrentErrorField a{settings, epoch, 3};
  const CurrentErrorField b{settings, epoch, 3};

  EXPECT_EQ(a.at({1.0, 2.0, 3.0}, epoch), b.at({1.0, 2.0, 3.0}, epoch));
  EXPECT_EQ(CurrentErrorField{}.at({1.0, 2.0, 3.0}, epoch), Vector{});
}

TEST(CurrentErrorSettings, NameEveryValueOutOfRange) {
  CurrentErrorSettings wrong;
  EXPECT_TRUE(wrong.violations().empty());

  wrong = {
      .rms = {-1.0}, .length_scale = {0.0}, .depth_scale = {std::nan("")}, .time_scale = core::Seconds{0.0}};
  EXPECT_EQ(wrong.violations().size(), 4U);
}

}  // namespace
}  // namespace floeplan::simulation::current_error_field_test

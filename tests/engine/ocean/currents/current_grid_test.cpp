#include "engine/ocean/currents/current_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "tests/engine/ocean/sample_currents.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ocean::current_grid_test {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();
const Axis levels{{0.0, 10.0, 50.0}};

core::UtcTime hour(double hours) { return core::from_unix_seconds(first_time_s + 3600.0 * hours); }

/// A different number for each sample, which no mean of other samples gives.
float scrambled(SampleIndex i) {
  const auto n = static_cast<double>(i.ix + 4 * (i.iy + 3 * (i.level + 3 * i.time)));
  return static_cast<float>(std::sin(12.9898 * n));
}

/// Linear in each of the four directions: the interpolation has to be exact.
float linear(SampleIndex i) {
  return 0.1F + 0.02F * static_cast<float>(i.ix) - 0.03F * static_cast<float>(i.iy) +
         0.04F * static_cast<float>(i.level) + 0.05F * static_cast<float>(i.time);
}

TEST(CurrentGrid, TellsWhetherItsGapsStayWhereTheyAre) {
  const auto with_gap = [](std::size_t first_time, std::size_t level) {
    return sample_currents(levels, 3, [=](SampleIndex i) {
      return i.ix == 1 && i.level >= level && i.time >= first_time ? missing : linear(i);
    });
  };

  EXPECT_TRUE(sample_currents(levels, 3, linear).has_steady_gaps());
  EXPECT_TRUE(with_gap(0, 1).has_steady_gaps());
  for (const std::size_t level : {0U, 2U}) {
    EXPECT_FALSE(with_gap(1, level).has_steady_gaps());
    EXPECT_FALSE(with_gap(2, level).has_steady_gaps());
  }
}

TEST(CurrentGrid, GivesBackItsSamplesToTheLastBitOnItsNodes) {
  const CurrentGrid currents = sample_currents(levels, 2, scrambled);

  for (std::size_t time = 0; time < 2; ++time) {
    for (std::size_t level = 0; level < 3; ++level) {
      for (std::size_t iy = 0; iy < 3; ++iy) {
        for (std::size_t ix = 0; ix < 4; ++ix) {
          const auto current = currents.at(currents.samples().grid.place(ix, iy), {levels[level]},
                                           hour(static_cast<double>(time)));

          const float expected = scrambled({ix, iy, level, time});
          ASSERT_TRUE(current.has_value());
          EXPECT_EQ(static_cast<float>(current->east.value), expected);
          EXPECT_EQ(static_cast<float>(current->north.value), -0.5F * expected);
        }
      }
    }
  }
}

TEST(CurrentGrid, FollowsAFieldThatIsLinearInPlaceDepthAndTime) {
  const CurrentGrid currents = sample_currents(levels, 4, linear);
  support::for_each_seed(500, [&](std::mt19937_64& rng) {
    const double dx = support::uniform(rng, 0.0, 3.0);
    const double dy = support::uniform(rng, 0.0, 2.0);
    const double depth_m = support::uniform(rng, 0.0, 50.0);
    const double hours = support::uniform(rng, 0.0, 3.0);
    const double level = depth_m < 10.0 ? depth_m / 10.0 : 1.0 + (depth_m - 10.0) / 40.0;

    const auto current = currents.at({-54.0 + dx, 68.0 + dy}, {depth_m}, hour(hours));

    ASSERT_TRUE(current.has_value());
    const double expected = 0.1 + 0.02 * dx - 0.03 * dy + 0.04 * level + 0.05 * hours;
    EXPECT_NEAR(current->east.value, expected, 1e-6);
    EXPECT_NEAR(current->north.value, -0.5 * expected, 1e-6);
  });
}

TEST(CurrentGrid, IsUnknownBeyondItsAreaDepthsAndPeriod) {
  const CurrentGrid currents = sample_currents(levels, 2, linear);

  EXPECT_TRUE(currents.at({-53.5, 68.5}, {50.0}, hour(1.0)).has_value());
  EXPECT_FALSE(currents.at({-54.1, 68.5}, {20.0}, hour(0.5)).has_value());
  EXPECT_FALSE(currents.at({-53.5, 70.1}, {20.0}, hour(0.5)).has_value());
  EXPECT_FALSE(currents.at({-53.5, 68.5}, {50.1}, hour(0.5)).has_value());
  EXPECT_FALSE(currents.at({-53.5, 68.5}, {-1.0}, hour(0.5)).has_value());
  EXPECT_FALSE(currents.at({-53.5, 68.5}, {20.0}, hour(-0.01)).has_value());
  EXPECT_FALSE(currents.at({-53.5, 68.5}, {20.0}, hour(1.01)).has_value());
}

TEST(CurrentGrid, AnswersAboveItsFirstLevelAsAtIt) {
  const CurrentGrid currents = sample_currents(Axis{{0.494, 10.0, 50.0}}, 2, linear);

  const auto at_first_level = currents.at({-53.5, 68.5}, {0.494}, hour(0.5));

  ASSERT_TRUE(at_first_level.has_value());
  EXPECT_EQ(currents.at({-53.5, 68.5}, {0.0}, hour(0.5)), at_first_level);
  EXPECT_EQ(currents.at({-53.5, 68.5}, {0.3}, hour(0.5)), at_first_level);
  EXPECT_FALSE(currents.at({-53.5, 68.5}, {-0.1}, hour(0.5)).has_value());
}

TEST(CurrentGrid, IsUnknownWhereverANodeItNeedsIsMissing) {
  const CurrentGrid currents = sample_currents(levels, 3, [](SampleIndex i) {
    const bool hole = i.ix == 1 && i.iy == 1 && i.level == 1 && i.time == 1;
    return hole ? missing : linear(i);
  });

  EXPECT_FALSE(currents.at({-53.0, 69.0}, {10.0}, hour(1.0)).has_value());
  EXPECT_FALSE(currents.at({-52.1, 69.0}, {10.0}, hour(1.0)).has_value());
  EXPECT_FALSE(currents.at({-53.0, 69.9}, {10.0}, hour(1.0)).has_value());
  EXPECT_FALSE(currents.at({-53.0, 69.0}, {49.0}, hour(1.0)).has_value());
  EXPECT_FALSE(currents.at({-53.0, 69.0}, {10.0}, hour(1.9)).has_value());
  EXPECT_TRUE(currents.at({-52.0, 69.0}, {10.0}, hour(1.0)).has_value());
  EXPECT_TRUE(currents.at({-53.0, 69.0}, {50.0}, hour(1.0)).has_value());
  EXPECT_TRUE(currents.at({-53.0, 69.0}, {10.0}, hour(2.0)).has_value());
}

TEST(CurrentGrid, WithoutADepthAxisAnswersForEveryDepth) {
  const CurrentGrid currents = sample_currents(std::nullopt, 1, linear);

  EXPECT_EQ(currents.at({-53.5, 68.5}, {0.0}, hour(0.0)), currents.at({-53.5, 68.5}, {900.0}, hour(0.0)));
}

TEST(CurrentGrid, RefusesToBeAskedWithWhatIsNotFinite) {
  const CurrentGrid currents = sample_currents(levels, 2, linear);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  EXPECT_THROW((void)currents.at({nan, 68.5}, {0.0}, hour(0.0)), std::invalid_argument);
  EXPECT_THROW((void)currents.at({-53.5, nan}, {0.0}, hour(0.0)), std::invalid_argument);
  EXPECT_THROW((void)currents.at({-53.5, 68.5}, {INFINITY}, hour(0.0)), std::invalid_argument);
  EXPECT_THROW((void)currents.at({-53.5, 68.5}, {0.0}, hour(nan)), std::invalid_argument);
}

TEST(CurrentGrid, NeedsASampleForEachNodeDepthAndTime) {
  CurrentGrid::Samples samples = sample_currents(levels, 2, linear).samples();
  samples.v.pop_back();

  EXPECT_THROW((CurrentGrid{std::move(samples)}), std::invalid_argument);
}

TEST(CurrentGrid, AveragesItsTimesNodeByNodeAndKeepsWhatIsMissingMissing) {
  const CurrentGrid currents = sample_currents(levels, 3, [](SampleIndex i) {
    const bool hole = i.ix == 3 && i.iy == 2 && i.level == 0 && i.time == 2;
    return hole ? missing : linear(i);
  });

  const CurrentGrid mean = currents.time_mean();

  EXPECT_EQ(mean.samples().times_s.size(), 1U);
  EXPECT_EQ(mean.samples().u.size(), currents.samples().u.size() / 3);
  const auto middle = currents.at({-53.2, 68.7}, {20.0}, hour(1.0));
  const auto averaged = mean.at({-53.2, 68.7}, {20.0}, hour(0.0));
  ASSERT_TRUE(middle.has_value() && averaged.has_value());
  EXPECT_NEAR(averaged->east.value, middle->east.value, 1e-6);
  EXPECT_NEAR(averaged->north.value, middle->north.value, 1e-6);
  EXPECT_FALSE(mean.at({-51.0, 70.0}, {0.0}, hour(0.0)).has_value());
}

}  // namespace
}  // namespace floeplan::ocean::current_grid_test

#include "engine/ocean/ice/ice_moment.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace floeplan::ocean::ice_moment_test {
namespace {

constexpr double hour_s = 3600.0;
constexpr double day_s = 86400.0;

IceStanding standing(const std::vector<double>& times_s, double time_s) {
  return ice_moment(times_s, time_s).standing;
}

TEST(IceMoment, IsOfTheDataThemselvesBetweenStepsOfTwoDaysAndOnAnyStep) {
  const std::vector<double> times_s{0.0, day_s, 3.0 * day_s, 23.0 * day_s};

  for (const double time_s : {0.0, 0.3 * day_s, 2.9 * day_s, 3.0 * day_s, 23.0 * day_s})
    EXPECT_EQ(standing(times_s, time_s), IceStanding::own) << time_s;
  EXPECT_DOUBLE_EQ(ice_moment(times_s, 1.5 * day_s).share, 0.25);
}

TEST(IceMoment, IsSpokenForADayAfterAStepAndHalfADayBeforeOne) {
  const std::vector<double> times_s{0.0, 20.0 * day_s};

  for (const double time_s : {-12.0 * hour_s, 24.0 * hour_s, 20.0 * day_s - 12.0 * hour_s, 21.0 * day_s})
    EXPECT_EQ(standing(times_s, time_s), IceStanding::speaks) << time_s;
  for (const double time_s : {-13.0 * hour_s, 25.0 * hour_s, 20.0 * day_s - 13.0 * hour_s, 21.1 * day_s})
    EXPECT_EQ(standing(times_s, time_s), IceStanding::held) << time_s;
}

TEST(IceMoment, IsUnknownFurtherThanThreeDaysFromAnyStep) {
  const std::vector<double> times_s{0.0, 20.0 * day_s};

  EXPECT_EQ(standing(times_s, -3.1 * day_s), IceStanding::not_begun);
  EXPECT_EQ(standing(times_s, 2.9 * day_s), IceStanding::held);
  EXPECT_EQ(standing(times_s, 3.1 * day_s), IceStanding::unknown);
  EXPECT_EQ(standing(times_s, 16.9 * day_s), IceStanding::unknown);
  EXPECT_EQ(standing(times_s, 17.1 * day_s), IceStanding::held);
  EXPECT_EQ(standing(times_s, 23.1 * day_s), IceStanding::unknown);
}

TEST(IceMoment, IsInterpolatedBetweenChartsOfAWeekAndHeldInLongerGaps) {
  const IceMoment week = ice_moment({0.0, 7.0 * day_s}, 3.5 * day_s);
  EXPECT_EQ(week.standing, IceStanding::held);
  EXPECT_DOUBLE_EQ(week.share, 0.5);

  const IceMoment before = ice_moment({0.0, 20.0 * day_s}, 2.0 * day_s);
  EXPECT_EQ(before.second, 0U);
  const IceMoment after = ice_moment({0.0, 20.0 * day_s}, 18.0 * day_s);
  EXPECT_EQ(after.first, 1U);
  EXPECT_EQ(after.away, core::Seconds{2.0 * day_s});
}

/// Law: what is known rests on steps that lie around the time or are near it.
TEST(IceMoment, RestsOnStepsAroundTheTimeOrNearIt) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    std::vector<double> times_s{support::uniform(rng, -10.0, 10.0) * day_s};
    while (times_s.size() < 6) times_s.push_back(times_s.back() + support::uniform(rng, 0.1, 12.0) * day_s);
    for (int i = 0; i < 50; ++i) {
      const double time_s = support::uniform(rng, -20.0, 80.0) * day_s;
      const IceMoment moment = ice_moment(times_s, time_s);

      ASSERT_LE(moment.first, moment.second);
      ASSERT_LE(moment.second, moment.first + 1);
      double nearest_s = 1e12;
      for (const double step_s : times_s) nearest_s = std::min(nearest_s, std::abs(step_s - time_s));
      EXPECT_DOUBLE_EQ(moment.away.count(), nearest_s);
      if (moment.first != moment.second) {
        const double between_s =
            times_s[moment.first] + moment.share * (times_s[moment.second] - times_s[moment.first]);
        EXPECT_NEAR(between_s, time_s, 1.0);
      } else if (moment.is_known()) {
        EXPECT_LE(nearest_s, longest_ice_hold.count());
      }
    }
  });
}

}  // namespace
}  // namespace floeplan::ocean::ice_moment_test

#include "engine/planning/problem/arrival_spread.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace floeplan::planning::arrival_spread_test {
namespace {

using core::Seconds;

TEST(ArrivalSpread, GivesMeanDeviationAndQuantilesOfItsMembers) {
  const ArrivalSpread spread{{Seconds{40.0}, Seconds{10.0}, Seconds{30.0}, Seconds{20.0}, Seconds{50.0}}};

  EXPECT_EQ(spread.arrived(), 5U);
  EXPECT_DOUBLE_EQ(spread.mean()->count(), 30.0);
  EXPECT_DOUBLE_EQ(spread.standard_deviation()->count(), std::sqrt(250.0));
  EXPECT_DOUBLE_EQ(spread.quantile(0.0)->count(), 10.0);
  EXPECT_DOUBLE_EQ(spread.quantile(0.5)->count(), 30.0);
  EXPECT_DOUBLE_EQ(spread.quantile(0.9)->count(), 46.0);
  EXPECT_DOUBLE_EQ(spread.quantile(1.0)->count(), 50.0);
  EXPECT_DOUBLE_EQ(spread.chance_within(Seconds{30.0}), 0.6);
  EXPECT_DOUBLE_EQ(spread.chance_within(Seconds{9.0}), 0.0);
}

TEST(ArrivalSpread, CountsAMemberThatNeverArrivesAsLaterThanEveryOther) {
  const ArrivalSpread spread{{Seconds{20.0}, std::nullopt, Seconds{10.0}, Seconds{30.0}}};

  EXPECT_EQ(spread.arrived(), 3U);
  EXPECT_DOUBLE_EQ(spread.mean()->count(), 20.0);
  EXPECT_DOUBLE_EQ(spread.quantile(0.5)->count(), 25.0);
  EXPECT_FALSE(spread.quantile(0.9).has_value());
  EXPECT_DOUBLE_EQ(spread.chance_within(Seconds{1e9}), 0.75);
}

TEST(ArrivalSpread, KnowsNothingOfMembersThatAllFail) {
  const ArrivalSpread spread{{std::nullopt, std::nullopt}};

  EXPECT_FALSE(spread.mean().has_value());
  EXPECT_FALSE(spread.standard_deviation().has_value());
  EXPECT_FALSE(spread.quantile(0.1).has_value());
  EXPECT_THROW(ArrivalSpread{{}}, std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::planning::arrival_spread_test

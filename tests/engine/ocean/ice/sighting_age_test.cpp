#include "engine/ocean/ice/sighting_age.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/property.hpp"

namespace floeplan::ocean::sighting_age_test {
namespace {

constexpr core::UtcTime midnight = core::from_unix_seconds(1.7954784e9);  // 2026-11-24T00:00:00Z
constexpr core::Seconds hour{3600.0};
constexpr core::Seconds day{86400.0};

TEST(SightingAge, TakesTheWholeDayOnWhichTheLongestAgeFalls) {
  EXPECT_EQ(oldest_that_counts(midnight, midnight, 3.0 * day), midnight - 3.0 * day);
  EXPECT_EQ(oldest_that_counts(midnight - hour, midnight - hour, 3.0 * day), midnight - 4.0 * day);
  EXPECT_EQ(oldest_that_counts(midnight + 23.0 * hour, midnight + 23.0 * hour, 1.5 * day), midnight - day);
}

TEST(SightingAge, IsThatAtTheDepartureHoweverLongTheVehicleIsUnderWay) {
  EXPECT_EQ(oldest_that_counts(midnight + 9.0 * day, midnight, 3.0 * day), midnight - 3.0 * day);
  EXPECT_EQ(oldest_that_counts(midnight, midnight + 9.0 * day, 3.0 * day), midnight - 3.0 * day)
      << "or at the moment after which nothing is to be known";
}

/// Law: both sides of the rule agree, and with a count of days done by hand; a sighting of the longest age always
/// counts, one a day older never does.
TEST(SightingAge, IsOneRuleFromBothSides) {
  support::for_each_seed(2000, [](std::mt19937_64& rng) {
    const core::Seconds age = std::floor(support::uniform(rng, 0.0, 30.0 * 24.0)) * hour;
    const core::UtcTime depart = midnight + std::floor(support::uniform(rng, -240.0, 240.0)) * hour;
    const core::UtcTime observed = depart - age + std::floor(support::uniform(rng, -72.0, 72.0)) * hour;

    const bool counts = observed >= oldest_that_counts(depart, depart, age);

    EXPECT_EQ(counts, depart < too_old_from(observed, age));
    const auto day_of = [](core::UtcTime time) { return std::floor(core::unix_seconds(time) / 86400.0); };
    EXPECT_EQ(counts, day_of(observed) >= day_of(depart - age));
    EXPECT_TRUE(counts || depart - observed > age);
    EXPECT_FALSE(counts && depart - observed > age + day);
  });
}

}  // namespace
}  // namespace floeplan::ocean::sighting_age_test

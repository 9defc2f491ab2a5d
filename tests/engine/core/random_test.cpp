#include "engine/core/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace floeplan::core::random_test {
namespace {

constexpr int draws = 40'000;

TEST(Random, GivesTheSameStreamForTheSameSeedAndName) {
  auto one = random_stream(7, "sonar");
  auto same = random_stream(7, "sonar");

  for (int i = 0; i < 100; ++i) EXPECT_EQ(one(), same());
}

TEST(Random, GivesEveryNameAndEverySeedAStreamOfItsOwn) {
  std::set<std::uint64_t> first_numbers;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (const char* name : {"sonar", "adcp", "compass", ""})
      first_numbers.insert(random_stream(seed, name)());
  }

  EXPECT_EQ(first_numbers.size(), 400U);
}

TEST(Random, GivesEveryRunOfABatchASeedOfItsOwn) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t run = 0; run < 1000; ++run) seeds.insert(seed_of_run(seed, run));
  }

  EXPECT_EQ(seeds.size(), 20'000U);
}

/// All bounds below are five standard errors of the mean of this number of draws.
TEST(Random, DrawsUniformNumbersOfTheRightMeanAndVariance) {
  auto rng = random_stream(1, "uniform");
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double x = uniform(rng);
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    sum += x;
    squares += (x - 0.5) * (x - 0.5);
  }

  EXPECT_NEAR(sum / draws, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / draws));
  EXPECT_NEAR(squares / draws, 1.0 / 12.0, 5.0 * std::sqrt(1.0 / 180.0 / draws));
}

TEST(Random, DrawsNormalNumbersOfTheRightMomentsAndTails) {
  auto rng = random_stream(2, "normal");
  double sum = 0.0;
  double squares = 0.0;
  double fourth = 0.0;
  int beyond_two = 0;
  for (int i = 0; i < draws; ++i) {
    const double x = normal(rng);
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
    beyond_two += std::abs(x) > 2.0 ? 1 : 0;
  }

  EXPECT_NEAR(sum / draws, 0.0, 5.0 / std::sqrt(draws));
  EXPECT_NEAR(squares / draws, 1.0, 5.0 * std::sqrt(2.0 / draws));
  EXPECT_NEAR(fourth / draws, 3.0, 5.0 * std::sqrt(96.0 / draws));
  EXPECT_NEAR(static_cast<double>(beyond_two) / draws, 0.0455, 5.0 * std::sqrt(0.0455 / draws));
}

TEST(Random, DrawsPoissonNumbersWhoseMeanIsTheirVariance) {
  for (const double mean : {0.0, 0.01, 0.5, 20.0}) {
    auto rng = random_stream(3, "poisson");
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < draws; ++i) {
      const double deviation = poisson(rng, mean) - mean;
      sum += deviation;
      squares += deviation * deviation;
    }

    EXPECT_NEAR(sum / draws, 0.0, 5.0 * std::sqrt(mean / draws));
    EXPECT_NEAR(squares / draws, mean, 5.0 * std::sqrt((mean + 2.0 * mean * mean) / draws));
  }
}

}  // namespace
}  // namespace floeplan::core::random_test

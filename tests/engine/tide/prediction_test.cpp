#include "engine/tide/prediction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/tide/minor_constituents.hpp"
#include "tests/engine/tide/published.hpp"
#include "tests/support/property.hpp"

namespace floeplan::tide::prediction_test {
namespace {

using support::for_each_seed;
using support::uniform;
using test::utc;

TEST(Prediction, OfTheSunsTideAloneIsACosineOfTheClock) {
  const std::vector<HarmonicConstant> sun{{find_constituent("S2").value(), harmonic_value(2.0, 60.0)}};
  EXPECT_NEAR(predict(sun, utc(2026, 3, 5, 2)), 2.0, 1e-9);  // 60 degrees of 30 an hour after midnight
  EXPECT_NEAR(predict(sun, utc(2026, 3, 5, 8)), -2.0, 1e-9);
  EXPECT_NEAR(predict(sun, utc(2019, 8, 1, 5)), 0.0, 1e-9);
}

TEST(Prediction, RefusesATimeThatIsNotFinite) {
  EXPECT_THROW(
      static_cast<void>(predict({}, core::from_unix_seconds(std::numeric_limits<double>::infinity()))),
      std::invalid_argument);
}

TEST(PhasorTable, GivesWhatTheSlowWayGivesForEveryLineOfTheCatalogue) {
  for_each_seed(20, [](std::mt19937_64& rng) {
    const core::UtcTime start = utc(1990, 1, 1) + core::Seconds{uniform(rng, 0.0, 2e9)};
    const core::Seconds step{uniform(rng, 60.0, 30'000.0)};
    const std::vector<Constituent> lines = all_constituents();
    const PhasorTable table{lines, start, step, 250};
    ASSERT_EQ(table.size(), 250U);

    for (const std::size_t i : {std::size_t{0}, std::size_t{1}, std::size_t{97}, std::size_t{249}}) {
      const auto time = start + static_cast<double>(i) * step;
      for (std::size_t c = 0; c < lines.size(); ++c) {
        const double slow = predict(std::vector{HarmonicConstant{lines[c], {0.6, -0.8}}}, time);
        const double fast = std::real(std::complex<double>{0.6, -0.8} * table.at(i)[c]);
        const double bound = constituent_name(lines[c]).size() > 3 ? 3e-3 : 1e-3;
        EXPECT_NEAR(fast, slow, bound) << constituent_name(lines[c]) << " at step " << i;
      }
    }
  });
}

TEST(PhasorTable, RefusesAStepOfNoLength) {
  EXPECT_THROW((PhasorTable{{}, utc(2026, 1, 1), core::Seconds{0.0}, 3}), std::invalid_argument);
}

TEST(MinorConstituents, AreInferredOnlyWhereAllSixMajorsAreThere) {
  std::vector<Constituent> majors;
  for (const char* name : {"M2", "S2", "N2", "K1", "O1"}) majors.push_back(find_constituent(name).value());
  EXPECT_TRUE(inferable_minors(majors).empty());

  majors.push_back(find_constituent("Q1").value());
  EXPECT_EQ(inferable_minors(majors).size(), 16U);
}

TEST(MinorConstituents, ThatWereGivenAreNotInferredTwice) {
  std::vector<Constituent> majors;
  for (const char* name : {"M2", "S2", "N2", "K1", "O1", "Q1", "L2", "NO1"})
    majors.push_back(find_constituent(name).value());
  const auto minors = inferable_minors(majors);
  EXPECT_EQ(minors.size(), 14U);
  for (const MinorConstituent& minor : minors)
    EXPECT_EQ(std::ranges::find(majors, minor.constituent), majors.end());
}

}  // namespace
}  // namespace floeplan::tide::prediction_test

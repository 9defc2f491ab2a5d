#include "tests/bench/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/property.hpp"

namespace floeplan::bench::comparison_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A row of each gauge, on a machine `machine` times as fast and a product `product` times as slow as normal.
std::vector<Row> measured(double machine, double product) {
  std::vector<Row> rows{
      gauged_by(Gauge::comparator,
                less_is_better("plan", "CPU s", 4.0 * product / machine, "calibration loop", 1.0 / machine)),
      gauged_by(Gauge::time,
                {.what = "step", .unit = "ms", .ours = 3.0 * product / machine, .comparator = {}}),
      gauged_by(Gauge::rate,
                {.what = "edges", .unit = "1/s", .ours = 7.0 * machine / product, .comparator = {}}),
      {.what = "cores", .unit = "s", .ours = product, .comparator = {}}};
  for (Row& row : rows) {
    row.group = "requests";
    row.calibration_s = 1.0 / machine;
  }
  return rows;
}

std::vector<Standing> kept() { return kept_standings(json_text(measured(1.0, 1.0))); }

TEST(Comparison, KeepsWhatHasAGauge) {
  EXPECT_THAT(kept(), SizeIs(3));
  EXPECT_EQ(kept()[0].what, "plan");
  EXPECT_EQ(kept()[0].group, "requests");
  EXPECT_EQ(kept()[0].comparator, "calibration loop");
}

TEST(Comparison, DependsOnTheProductAndNotOnTheMachine) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const double machine = support::uniform(rng, 0.1, 10.0);
    const double product = support::uniform(rng, 0.2, 2.0);

    const auto fallen = regressions(kept(), standings(measured(machine, product)), {"requests"});

    EXPECT_EQ(fallen.size(), product > 1.0 + tolerated_slowdown ? 3U : 0U) << machine << ' ' << product;
  });
}

TEST(Comparison, NamesWhatFellBackAndByHowMuch) {
  const auto fallen = regressions(kept(), standings(measured(2.0, 1.23)), {"requests"});

  ASSERT_THAT(fallen, SizeIs(3));
  EXPECT_EQ(sentence(fallen[0]), "plan (beside calibration loop): 23 % slower");
  EXPECT_EQ(sentence(fallen[1]), "step: 23 % slower");
}

TEST(Comparison, MissesARowThatIsNoLongerMeasuredAndMindsNoNewOne) {
  auto rows = measured(1.0, 1.0);
  rows.erase(rows.begin());
  rows.push_back(gauged_by(Gauge::time, {.what = "new", .unit = "s", .ours = 9.0, .comparator = {}}));

  const auto fallen = regressions(kept(), standings(rows), {"requests"});

  ASSERT_THAT(fallen, SizeIs(1));
  EXPECT_EQ(sentence(fallen[0]), "plan (beside calibration loop): is no longer measured");
}

TEST(Comparison, LeavesOutGroupsThatWereNotMeasured) {
  EXPECT_THAT(regressions(kept(), {}, {"search"}), IsEmpty());
}

TEST(Comparison, TakesTheBetterOfTwoRuns) {
  const auto disturbed = standings(measured(1.0, 1.5));
  const auto again = standings(measured(1.0, 1.1));

  EXPECT_THAT(regressions(kept(), better_of(disturbed, again), {"requests"}), IsEmpty());
  EXPECT_THAT(regressions(kept(), better_of(again, disturbed), {"requests"}), IsEmpty());
  EXPECT_THAT(regressions(kept(), better_of(disturbed, {}), {"requests"}), SizeIs(3));
}

TEST(Comparison, RefusesAFileOfAnotherKind) {
  for (const char* text : {"", "[]", "{}", "7", "[1, 2]", "[{\"what\": \"plan\"}]", "[{\"standing\": 2}]",
                           "[{\"group\": 1, \"what\": \"plan\", \"standing\": 2}]",
                           "[{\"group\": \"g\", \"what\": \"plan\", \"standing\": 0}]"})
    EXPECT_THROW((void)kept_standings(text), std::runtime_error) << text;
}

}  // namespace
}  // namespace floeplan::bench::comparison_test

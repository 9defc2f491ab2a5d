#include "engine/simulation/flight/batch_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "engine/core/random.hpp"

namespace floeplan::simulation::batch_statistics_test {
namespace {

std::vector<double> one_to(int last) {
  std::vector<double> values;
  for (int i = last; i >= 1; --i) values.push_back(i);
  return values;
}

TEST(Distribution, HasTheMomentsAndQuantilesOfItsValues) {
  const auto found = distribution_of(one_to(101));

  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->runs, 101U);
  EXPECT_NEAR(found->mean, 51.0, 1e-12);
  EXPECT_NEAR(found->standard_deviation.value(), std::sqrt(101.0 * 102.0 / 12.0), 1e-9);
  EXPECT_EQ(found->quantiles[0].value, 6.0);
  EXPECT_EQ(found->quantiles[2].value, 51.0);
  EXPECT_EQ(found->quantiles[4].value, 96.0);
  EXPECT_EQ(found->least, 1.0);
  EXPECT_EQ(found->most, 101.0);
}

TEST(Distribution, HasStudentsIntervalOfTheMean) {
  // t tables: 12.7062 with one degree of freedom, 2.7764 with four, 2.0452 with 29.
  for (const auto& [n, t] : {std::pair{2, 12.7062}, std::pair{5, 2.7764}, std::pair{30, 2.0452}}) {
    const auto found = distribution_of(one_to(n));
    const double half = found->mean_interval->high - found->mean;
    EXPECT_NEAR(half * std::sqrt(n) / found->standard_deviation.value(), t, 0.003) << n;
  }
}

TEST(Distribution, OfDistancesHasNoNegativeInterval) {
  EXPECT_EQ(distribution_of({0.0, 1.0, 20.0})->mean_interval->low, 0.0);
  EXPECT_LT(distribution_of({-1.0, 1.0, 20.0})->mean_interval->low, -1.0);
}

TEST(Distribution, HasTheMediansIntervalOfTheBinomialTable) {
  // David and Nagaraja: of ten values the second and the ninth hold the median with 97.9 %.
  const auto found = distribution_of(one_to(10));

  EXPECT_EQ(found->quantiles[2].interval, (Interval{2.0, 9.0}));
  EXPECT_FALSE(found->quantiles[0].interval.has_value());
}

TEST(Distribution, OfASingleRunHasNoIntervals) {
  const auto found = distribution_of({7.0});

  EXPECT_EQ(found->mean, 7.0);
  EXPECT_FALSE(found->mean_interval || found->standard_deviation || found->quantiles[2].interval);
  EXPECT_FALSE(distribution_of({}).has_value());
}

TEST(Distribution, HoldsTheTrueMedianInItsIntervalAsOftenAsItSays) {
  auto rng = core::random_stream(1, "median");
  int held = 0;
  constexpr int batches = 600;
  for (int batch = 0; batch < batches; ++batch) {
    std::vector<double> values;
    for (int run = 0; run < 60; ++run) values.push_back(std::exp(core::normal(rng)));
    const auto interval = distribution_of(std::move(values))->quantiles[2].interval;
    held += interval->low <= 1.0 && interval->high >= 1.0 ? 1 : 0;
  }

  EXPECT_GT(held, 0.93 * batches);
  EXPECT_LT(held, 0.995 * batches);
}

TEST(Share, HasWilsonsInterval) {
  // Newcombe 1998, Stat. Med. 17, table I: 81 of 263 gives 0.2553 to 0.3662; 0 of 20 gives 0 to 0.1611.
  const Share some = share_of(81, 263);
  const Share none = share_of(0, 20);

  EXPECT_NEAR(some.interval.low, 0.2553, 5e-5);
  EXPECT_NEAR(some.interval.high, 0.3662, 5e-5);
  EXPECT_EQ(none.interval.low, 0.0);
  EXPECT_NEAR(none.interval.high, 0.1611, 5e-5);
}

FlightRecord flight(FlightEnd end, double hours, double error_m, double clearance_m) {
  FlightRecord record;
  record.end = end;
  record.finished = record.departure + core::Seconds{3600.0 * hours};
  record.energy = {1000.0 * hours};
  TrackPoint point;
  point.believed.east = 2.0 * error_m;
  record.track.push_back(point);
  point.believed.east = error_m;
  record.track.push_back(point);
  record.approaches.push_back({"sea bed", 3.0 * clearance_m, {}, {}});
  record.approaches.push_back({"berg", clearance_m, {}, {}});
  return record;
}

TEST(BatchStatistics, TellsArrivalsApartFromOtherEnds) {
  std::vector<RunSummary> runs;
  for (int i = 1; i <= 8; ++i) runs.push_back(summary_of(flight(FlightEnd::arrived, 10.0 + i, i, 50.0)));
  runs.push_back(summary_of(flight(FlightEnd::collided, 3.0, 5.0, 0.0)));
  runs.push_back(summary_of(flight(FlightEnd::time_up, 99.0, 5.0, 40.0)));

  const BatchStatistics found = statistics_of(runs);

  ASSERT_EQ(found.ends.size(), 3U);
  EXPECT_EQ(found.ends[0].share.runs, 8U);
  EXPECT_EQ(found.ends[1].end, FlightEnd::collided);
  EXPECT_EQ(found.travel_time_s->runs, 8U);
  EXPECT_NEAR(found.travel_time_s->mean, 3600.0 * 14.5, 1e-6);
  EXPECT_EQ(found.clearance_m->runs, 10U);
  EXPECT_EQ(found.clearance_m->least, 0.0);
  EXPECT_EQ(found.final_position_error_m->most, 8.0);
  EXPECT_EQ(found.worst_position_error_m->most, 16.0);
}

TEST(BatchStatistics, OfNoRunsIsEmpty) { EXPECT_FALSE(statistics_of({}).travel_time_s.has_value()); }

}  // namespace
}  // namespace floeplan::simulation::batch_statistics_test

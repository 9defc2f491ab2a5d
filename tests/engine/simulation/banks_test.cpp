#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "tests/engine/simulation/graded_bed.hpp"
#include "tests/engine/simulation/guided.hpp"

/// Sea beds within the saw-tooth, in the closed loop of flight model, sonar, altimeter and the system on board.
namespace floeplan::simulation::banks_test {
namespace {

using support::graded_bed;
using support::guided;
using support::nearest_m;
using support::ramp;
using support::share_steered;

World sea_over(SeaBed bed, TrueCurrent current = {}) {
  return World{{.origin = support::flight_origin,
                .bed = std::move(bed),
                .ice = {},
                .current = std::move(current),
                .bodies = {}}};
}

/// The altimeter turns the vehicle; nothing is gone round.
void expect_flown_over(const World& world, const std::string& what) {
  const FlightRecord record = guided(world, {});
  EXPECT_EQ(record.end, FlightEnd::arrived) << what << ": " << record.end_reason;
  EXPECT_LT(share_steered(record), 0.02) << what;
  EXPECT_GT(nearest_m(record, "sea bed"), 5.0) << what;
  EXPECT_LT(record.distance_m, 920.0) << what;
}

TEST(Bank, ThatIsFlatIsFlownOverOnTheRoute) {
  for (const double bed_m : {60.0, 40.0, 25.0})
    expect_flown_over(sea_over(SeaBed{core::Metres{bed_m}}), std::to_string(bed_m));
}

TEST(Bank, ThatRisesGentlyIsFlownOverOnTheRoute) {
  const auto depth_m = [](double east_m, double /*north_m*/) {
    return ramp(east_m, 100.0, 700.0, 110.0, 35.0);
  };
  expect_flown_over(sea_over(graded_bed(depth_m)), "from 110 to 35 m in 600 m");
}

/// A nearly upright bank: its echoes from steeply above must not count as ice to dive under.
TEST(Bank, ThatRisesLikeAWallIsGoneRound) {
  const auto depth_m = [](double east_m, double north_m) {
    const double outside_m = std::max({620.0 - east_m, east_m - 820.0, std::abs(north_m) - 150.0});
    return ramp(outside_m, 0.0, 25.0, 12.0, 110.0);
  };
  const FlightRecord record = guided(sea_over(graded_bed(depth_m)), {.way = {{1000.0, 0.0, 0.0}}});
  EXPECT_EQ(record.end, FlightEnd::arrived) << record.end_reason;
  EXPECT_GT(nearest_m(record, "sea bed"), 5.0);
}

TEST(Bank, WithoutEndIsNotRunOnto) {
  const auto depth_m = [](double east_m, double /*north_m*/) {
    return ramp(east_m, 475.0, 500.0, 110.0, 12.0);
  };
  const FlightRecord record = guided(sea_over(graded_bed(depth_m, {{-600.0, -1000.0}, {1500.0, 1000.0}})),
                                     {.way = {{1400.0, 0.0, 0.0}}, .longest = core::Seconds{3000.0}});
  EXPECT_EQ(record.end, FlightEnd::time_up) << record.end_reason;
  EXPECT_GT(nearest_m(record, "sea bed"), 5.0);
}

/// The current sets onto the bank at half the speed of the vehicle; neither the plan nor the vehicle knows
/// it.
TEST(Bank, BesideTheRouteIsNotBlownOnto) {
  const CurrentErrorField error{
      {.rms = {0.2}, .length_scale = {50'000.0}, .depth_scale = {1000.0}, .time_scale = core::Seconds{1e6}},
      support::flight_start,
      4};
  ASSERT_LT(error.at({0.0, 0.0, 50.0}, support::flight_start).north, -0.15);
  const auto depth_m = [](double /*east_m*/, double north_m) {
    return ramp(-north_m, 100.0, 150.0, 110.0, 25.0);
  };
  const FlightRecord record =
      guided(sea_over(graded_bed(depth_m), TrueCurrent{Vector{}, error}),
             {.way = {{1400.0, 0.0, 0.0}}, .longest = core::Seconds{3000.0}, .seed = 4});
  EXPECT_EQ(record.end, FlightEnd::time_up) << record.end_reason;
  EXPECT_GT(nearest_m(record, "sea bed"), 5.0);
}

}  // namespace
}  // namespace floeplan::simulation::banks_test

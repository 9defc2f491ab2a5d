#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/engine/simulation/graded_bed.hpp"
#include "tests/engine/simulation/guided.hpp"

/// Sea beds within the saw-tooth, in the closed loop of flight model, sonar, altimeter and the system on board.
namespace floeplan::simulation {
namespace {

using support::graded_bed;
using support::guided;
using support::nearest_m;
using support::ramp;
using support::share_steered;

World sea_over(SeaBed bed) {
  return World{
      {.origin = support::flight_origin, .bed = std::move(bed), .ice = {}, .current = {}, .bodies = {}}};
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

}  // namespace
}  // namespace floeplan::simulation

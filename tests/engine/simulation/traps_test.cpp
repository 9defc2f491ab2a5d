#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/simulation/graded_bed.hpp"
#include "tests/engine/simulation/guided.hpp"

/// Situations made by hand in which a simpler system fails, in the closed loop of flight model, sensors,
/// mission and the system on board.
namespace floeplan::simulation::traps_test {
namespace {

using support::graded_bed;
using support::guided;
using support::GuidedFlight;
using support::nearest_m;
using support::ramp;
using support::share_steered;

constexpr double draft_m = 120.0;

/// An upright block of ice about its middle: half its length to the east and its width to the north.
ConvexPart block(double east_m, double north_m, double half_east_m, double half_north_m, double deep_m) {
  return ConvexPart{{{{1.0, 0.0, 0.0}, north_m + half_north_m},
                     {{-1.0, 0.0, 0.0}, half_north_m - north_m},
                     {{0.0, 1.0, 0.0}, east_m + half_east_m},
                     {{0.0, -1.0, 0.0}, half_east_m - east_m},
                     {{0.0, 0.0, 1.0}, deep_m},
                     {{0.0, 0.0, -1.0}, 10.0}}};
}

/// Parts as seen from the place, moving at a velocity.
Body body(std::string name, std::vector<ConvexPart> parts, double radius_m, double deep_m, Vector place,
          Vector drift = {}) {
  constexpr core::Seconds lasts{8.0 * 3600.0};
  const Vector last = place + lasts.count() * drift;
  return {std::move(name), Shape{.parts = std::move(parts), .radius_m = radius_m, .draft_m = deep_m},
          Body::Motion{.track = {{support::flight_start, place.east, place.north},
                                 {support::flight_start + lasts, last.east, last.north}}}};
}

Body cube(std::string name, double half_m, Vector place, Vector drift = {}) {
  return body(std::move(name), {block(0.0, 0.0, half_m, half_m, draft_m)}, 1.5 * half_m, draft_m, place,
              drift);
}

World sea_with(std::vector<Body> bodies, SeaBed bed = {}) {
  return World{{.origin = support::flight_origin,
                .bed = std::move(bed),
                .ice = {},
                .current = {},
                .bodies = std::move(bodies)}};
}

GuidedFlight eastward() { return {.way = {{1400.0, 0.0, 0.0}}, .longest = core::Seconds{6.0 * 3600.0}}; }

void expect_saved(const World& world, GuidedFlight flight) {
  const FlightRecord with = guided(world, flight);
  EXPECT_EQ(with.end, FlightEnd::arrived) << with.end_reason;
  EXPECT_GT(nearest_m(with, "berg"), 5.0);
  flight.has_system = false;
  EXPECT_EQ(guided(world, flight).end, FlightEnd::collided);
}

/// Open towards the vehicle, its arms 150 m long and 180 m apart.
TEST(TrapInTheLoop, HollowBergIsLeftByWhereItWasEntered) {
  const World world =
      sea_with({body("berg",
                     {block(0.0, 0.0, 20.0, 130.0, draft_m), block(-75.0, 110.0, 75.0, 20.0, draft_m),
                      block(-75.0, -110.0, 75.0, 20.0, draft_m)},
                     220.0, draft_m, {800.0, 0.0, 0.0})});
  expect_saved(world, eastward());
}

TEST(TrapInTheLoop, ClosingGapIsNotEntered) {
  constexpr double speed = 0.08;
  const double apart_m = 80.0 + 1430.0 * speed;
  const World world = sea_with({cube("berg to the north", 60.0, {560.0, apart_m, 0.0}, {0.0, -speed, 0.0}),
                                cube("berg to the south", 60.0, {560.0, -apart_m, 0.0}, {0.0, speed, 0.0})});
  expect_saved(world, eastward());
}

/// The berg comes from behind and beside and crosses the route: a sonar that looks abeam hears it draw level.
TEST(TrapInTheLoop, OvertakingBergIsLetPass) {
  GuidedFlight flight = eastward();
  flight.sonar.beams = 46;
  flight.sonar.beam_step_rad = std::numbers::pi / 45.0;
  expect_saved(sea_with({cube("berg", 60.0, {-200.0, 170.0, 0.0}, {0.4, -0.05, 0.0})}), flight);
}

/// Round the berg to the south the water is too shoal to work in.
TEST(TrapInTheLoop, ShallowBankBesideABergIsNotTakenForTheWayRound) {
  const auto depth_m = [](double east_m, double north_m) {
    return ramp(std::hypot(0.5 * (east_m - 800.0), north_m + 190.0), 60.0, 180.0, 8.0, 130.0);
  };
  const World world = sea_with({cube("berg", 60.0, {800.0, 40.0, 0.0})}, graded_bed(depth_m));
  const FlightRecord record = guided(world, eastward());
  EXPECT_EQ(record.end, FlightEnd::arrived) << record.end_reason;
  EXPECT_GT(nearest_m(record, "berg"), 5.0);
  EXPECT_GT(nearest_m(record, "sea bed"), 4.0);
}

TEST(TrapInTheLoop, CeilingOfIceIsPassedUnder) {
  const World world =
      sea_with({body("berg", {block(0.0, 0.0, 350.0, 1500.0, 25.0)}, 1600.0, 25.0, {750.0, 0.0, 0.0})});
  const FlightRecord record = guided(world, eastward());
  EXPECT_EQ(record.end, FlightEnd::arrived) << record.end_reason;
  EXPECT_GT(nearest_m(record, "berg"), 2.0);
}

/// The vehicle cannot surface at the goal, so it goes back to open water.
TEST(TrapInTheLoop, CeilingOfIceOverTheGoalIsLeftByWhereItWasEntered) {
  const World world =
      sea_with({body("berg", {block(0.0, 0.0, 1500.0, 1500.0, 25.0)}, 2200.0, 25.0, {2300.0, 0.0, 0.0})});
  GuidedFlight flight = eastward();
  flight.longest = core::Seconds{24.0 * 3600.0};
  const FlightRecord record = guided(world, flight);
  EXPECT_EQ(record.end, FlightEnd::gave_up) << record.end_reason;
  EXPECT_NE(record.end_reason.find("went back"), std::string::npos) << record.end_reason;
  EXPECT_LT(record.track.back().position.east, 800.0);
  EXPECT_GT(nearest_m(record, "berg"), 2.0);
}

}  // namespace
}  // namespace floeplan::simulation::traps_test

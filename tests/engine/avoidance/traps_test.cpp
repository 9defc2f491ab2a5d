#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/avoidance/guidance.hpp"
#include "tests/engine/avoidance/light/voyage.hpp"

/// Situations made by hand in which a simpler system fails. Each is flown with path planning and by reactive
/// control alone, with several seeds of the sensors' noise.
namespace floeplan::avoidance::traps_test {
namespace {

using support::Body;
using support::Ending;
using support::Flight;
using support::FlightResult;

constexpr double east_rad = std::numbers::pi / 2.0;
constexpr double draft_m = 90.0;

/// A flight of 1,600 m to the east.
Flight eastward() {
  Flight flight;
  flight.waypoints = {{1600.0, 0.0}};
  flight.most_s = 6.0 * 1600.0 / flight.vehicle.through_water_m_s;
  flight.settings.deepest = core::Metres{flight.vehicle.deepest_m};
  return flight;
}

/// An upright wall of ice from the surface down, its length along the bearing.
Body wall(double east_m, double north_m, double half_length_m, double half_width_m, double bearing_rad) {
  Body body;
  body.shape = Body::Shape::box;
  body.centre = {east_m, north_m, 0.0};
  body.half_axes = {half_length_m, half_width_m, draft_m};
  body.bearing_rad = bearing_rad;
  return body;
}

Body round_berg(double east_m, double north_m, double radius_m, geo::PlaneVelocity drift) {
  Body body;
  body.centre = {east_m, north_m, 0.0};
  body.half_axes = {radius_m, radius_m, 1.5 * draft_m};
  body.drift = drift;
  return body;
}

/// Open towards the vehicle, its arms `arm_m` long and 200 m apart.
std::vector<Body> hollow_berg(double arm_m, geo::PlaneVelocity drift) {
  std::vector<Body> parts{wall(900.0, 0.0, 130.0, 20.0, 0.0),
                          wall(900.0 - 0.5 * arm_m, 110.0, 0.5 * arm_m, 20.0, east_rad),
                          wall(900.0 - 0.5 * arm_m, -110.0, 0.5 * arm_m, 20.0, east_rad)};
  for (Body& part : parts) part.drift = drift;
  return parts;
}

void expect_safe_arrival(Flight flight, const std::string& what) {
  for (const bool plans : {true, false}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      flight.plans_paths = plans;
      flight.seed = seed;
      const FlightResult result = support::fly(flight);
      EXPECT_EQ(result.ending, Ending::arrived)
          << what << (plans ? ", with paths" : ", reactive alone") << ", seed " << seed << ": after "
          << result.time_s << " s at " << result.last.east_m << " " << result.last.north_m << " depth "
          << result.last.depth_m << ", " << text(result.reason);
    }
  }
}

TEST(Trap, HollowBergIsLeftByWhereItWasEntered) {
  Flight flight = eastward();
  flight.sea.bodies = hollow_berg(150.0, {});
  expect_safe_arrival(flight, "150 m deep");
  flight.sea.bodies = hollow_berg(250.0, {});
  expect_safe_arrival(flight, "250 m deep");
  flight.sea.bodies = hollow_berg(150.0, {-0.1, 0.05});
  expect_safe_arrival(flight, "drifting onto the vehicle");
}

TEST(Trap, ClosingGapIsNotEntered) {
  Flight flight = eastward();
  for (const double speed : {0.06, 0.1, 0.14}) {
    const double apart_m = 60.0 + 1430.0 * speed;
    flight.sea.bodies = {round_berg(560.0, apart_m, 60.0, {0.0, -speed}),
                         round_berg(560.0, -apart_m, 60.0, {0.0, speed})};
    expect_safe_arrival(flight, "closing at " + std::to_string(2.0 * speed) + " m/s");
  }
}

/// Only a sonar that looks astern can see this berg approach.
TEST(Trap, OvertakingBergIsLetPass) {
  Flight flight = eastward();
  flight.sonar.half_width_deg = 180.0;
  flight.sonar.bearing_step_deg = 4.0;
  for (const double aside_m : {-40.0, 5.0, 60.0}) {
    flight.sea.bodies = {round_berg(-350.0, aside_m, 60.0, {0.5, 0.0})};
    expect_safe_arrival(flight, "overtaking " + std::to_string(aside_m) + " m aside");
  }
}

TEST(Trap, ShallowBankBesideABergIsNotMistakenForTheWayRound) {
  Flight flight = eastward();
  flight.sea.bed_m = 60.0;
  flight.vehicle.deepest_m = 40.0;
  flight.settings.deepest = core::Metres{40.0};
  Body bank;
  bank.centre = {800.0, -170.0, 60.0};
  bank.half_axes = {250.0, 140.0, 57.0};
  bank.bearing_rad = east_rad;
  bank.is_fixed = true;
  flight.sea.bodies = {bank, round_berg(800.0, 75.0, 70.0, {})};
  expect_safe_arrival(flight, "bank to the south");
}

TEST(Trap, CeilingOfIceIsPassedUnder) {
  Flight flight = eastward();
  flight.vehicle.deepest_m = 100.0;
  flight.settings.deepest = core::Metres{100.0};
  Body cover = wall(1000.0, 0.0, 500.0, 1500.0, east_rad);
  cover.half_axes.depth_m = 25.0;
  flight.sea.bodies = {cover};
  expect_safe_arrival(flight, "ice 25 m deep");
}

}  // namespace
}  // namespace floeplan::avoidance::traps_test

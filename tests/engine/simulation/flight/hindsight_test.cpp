#include "engine/simulation/flight/hindsight.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/engine/simulation/flown.hpp"

namespace floeplan::simulation::hindsight_test {
namespace {

using support::flight_origin;
using support::flight_start;
using support::flown;
using support::orders_through;
using support::perfect_sensors;

ConvexPart wall(double middle_along_m, double half_along_m, double middle_across_m, double half_across_m) {
  return ConvexPart{{{{1.0, 0.0, 0.0}, middle_along_m + half_along_m},
                     {{-1.0, 0.0, 0.0}, half_along_m - middle_along_m},
                     {{0.0, 1.0, 0.0}, middle_across_m + half_across_m},
                     {{0.0, -1.0, 0.0}, half_across_m - middle_across_m},
                     {{0.0, 0.0, 1.0}, 150.0},
                     {{0.0, 0.0, -1.0}, 10.0}}};
}

World sea_with(std::vector<ConvexPart> parts, Vector place) {
  WorldParts world{.origin = flight_origin};
  world.bodies.emplace_back("berg", Shape{.parts = std::move(parts), .radius_m = 900.0, .draft_m = 150.0},
                            Body::Motion{.track = {{flight_start, place.east, place.north}}});
  return World{std::move(world)};
}

/// Without a system on board, 2 km to the east.
FlightRecord flown_blindly(const World& world) {
  return flown(world, orders_through(world, {{2000.0, 0.0, 0.0}}), perfect_sensors());
}

TEST(Hindsight, SavesAFlightThatCouldHaveTurnedAway) {
  const World world = sea_with({wall(0.0, 60.0, 0.0, 60.0)}, {900.0, 0.0, 0.0});
  const FlightRecord record = flown_blindly(world);
  ASSERT_EQ(record.end, FlightEnd::collided);
  EXPECT_EQ(could_be_saved(world, record, {}), true);
}

/// Walls on three sides and hardly room to turn between them.
TEST(Hindsight, DoesNotSaveAFlightThatIsShutInWhenItFirstHears) {
  const World world = sea_with({wall(0.0, 200.0, 160.0, 10.0), wall(15.0, 5.0, 0.0, 200.0),
                                wall(-15.0, 5.0, 0.0, 200.0), wall(0.0, 200.0, -30.0, 10.0)},
                               {800.0, 0.0, 0.0});
  FlightRecord record;
  record.end = FlightEnd::collided;
  record.departure = flight_start;
  record.finished = flight_start + core::Seconds{60.0};
  record.track = {{.time = flight_start, .position = {860.0, 0.0, 20.0}}};
  record.events = {{.time = record.finished, .kind = EventKind::contact, .position = {}, .text = "berg"}};
  EXPECT_EQ(could_be_saved(world, record, {}), false);
}

TEST(Hindsight, IsOfFlightsAloneThatTouchedSomething) {
  const World world = sea_with({wall(0.0, 60.0, 0.0, 60.0)}, {900.0, 800.0, 0.0});
  const FlightRecord record = flown_blindly(world);
  ASSERT_EQ(record.end, FlightEnd::arrived);
  EXPECT_FALSE(could_be_saved(world, record, {}).has_value());
}

}  // namespace
}  // namespace floeplan::simulation::hindsight_test

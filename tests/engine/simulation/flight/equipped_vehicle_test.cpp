#include "engine/simulation/flight/equipped_vehicle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/core/random.hpp"
#include "engine/simulation/world/iceberg_shape.hpp"
#include "tests/engine/simulation/flown.hpp"

namespace floeplan::simulation::equipped_vehicle_test {
namespace {

using support::flight_origin;
using support::flight_start;
using support::orders_through;
using support::perfect_sensors;
using support::shallow_glider;

World sea_with_berg_at(std::vector<Vector> places) {
  WorldParts parts{.origin = flight_origin};
  parts.bed = SeaBed{core::Metres{320.0}};
  auto rng = core::random_stream(1, "berg");
  for (const Vector& place : places) {
    parts.bodies.emplace_back("berg", iceberg_shape(IcebergForm::blocky, {120.0}, {110.0}, rng),
                              Body::Motion{.track = {{flight_start, place.east, place.north}}});
  }
  return World{std::move(parts)};
}

FlightRecord fly_equipped(const World& world, bool avoidance, std::uint64_t seed = 1,
                          core::Seconds longest = core::Seconds{86400.0}) {
  const MissionOrders orders = orders_through(world, {{3000.0, 0.0, 0.0}});
  const Equipment equipment;
  std::optional<SystemOnBoard> system;
  if (avoidance) {
    system = system_for(world, orders, flight_origin, flight_start, core::Seconds{86400.0});
    system->settings = avoidance_for(shallow_glider(), orders, equipment.sonar.settings());
  }
  FlightSettings settings = perfect_sensors();
  settings.longest = longest;
  EquippedVehicle vehicle{equipment, world, seed, system};
  FlightRecord record = fly({.world = world,
                             .orders = orders,
                             .vehicle = shallow_glider(),
                             .start = flight_origin,
                             .departure = flight_start,
                             .settings = settings,
                             .seed = seed},
                            vehicle);
  record.sensors.sonar = vehicle.log().sonar;
  record.sensors.altimeter = vehicle.log().altimeter;
  record.sensors.currents = vehicle.log().currents;
  return record;
}

bool has_evaded(const FlightRecord& record) {
  return std::ranges::any_of(record.track,
                             [](const TrackPoint& point) { return point.mode != avoidance::Mode::mission; });
}

TEST(EquippedVehicle, ArrivesInOpenWaterAndLogsItsSensors) {
  const World world = sea_with_berg_at({});

  const FlightRecord record = fly_equipped(world, true);

  EXPECT_EQ(record.end, FlightEnd::arrived) << record.end_reason;
  EXPECT_GT(record.sensors.currents.size(), 10U);
}

TEST(EquippedVehicle, RunsIntoTheBergWithoutTheSystemAndRoundItWithIt) {
  const World world = sea_with_berg_at({{1500.0, 0.0, 0.0}});

  const FlightRecord without = fly_equipped(world, false);
  const FlightRecord with = fly_equipped(world, true);

  EXPECT_EQ(without.end, FlightEnd::collided);
  EXPECT_EQ(with.end, FlightEnd::arrived) << with.end_reason;
  EXPECT_FALSE(with.sensors.sonar.empty());
  EXPECT_TRUE(has_evaded(with));
}

TEST(EquippedVehicle, LeavesTheSameRecordForTheSameSeed) {
  const World world = sea_with_berg_at({{900.0, 20.0, 0.0}});

  constexpr core::Seconds into_the_evasion{3000.0};

  const FlightRecord record = fly_equipped(world, true, 5, into_the_evasion);

  EXPECT_EQ(record, fly_equipped(world, true, 5, into_the_evasion));
  EXPECT_TRUE(has_evaded(record));
}

}  // namespace
}  // namespace floeplan::simulation::equipped_vehicle_test

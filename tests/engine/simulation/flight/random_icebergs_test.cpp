#include "engine/simulation/flight/random_icebergs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation/flight/equipped_vehicle.hpp"

namespace floeplan::simulation::random_icebergs_test {
namespace {

constexpr geo::LonLat start{-50.0, 69.0};
constexpr core::UtcTime departure = core::from_unix_seconds(1.7e9);

/// FLOEPLAN_ICEBERG_FIELDS sets the number of fields, usually a few; FLOEPLAN_ICEBERG_SEED sets the first
/// seed, usually 1.
std::uint64_t asked(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}
std::uint64_t fields() { return asked("FLOEPLAN_ICEBERG_FIELDS", 2); }
std::uint64_t first_seed() { return asked("FLOEPLAN_ICEBERG_SEED", 1); }

FlightRecord fly_through(const IcebergField& field, std::uint64_t seed, bool avoids) {
  static const Equipment equipment;
  const core::Seconds longest = longest_flight({}, field.vehicle);
  std::optional<SystemOnBoard> system;
  if (avoids) {
    system = system_for(field.world, field.orders, start, departure, longest);
    system->settings = avoidance_for(field.vehicle, field.orders, equipment.sonar.settings());
  }
  EquippedVehicle vehicle{equipment, field.world, seed, system};
  return fly({.world = field.world,
              .orders = field.orders,
              .vehicle = field.vehicle,
              .start = start,
              .departure = departure,
              .settings = {.longest = longest, .known_current = field.forecast},
              .seed = seed},
             vehicle);
}

double nearest_m(const FlightRecord& record) {
  double nearest = 1e9;
  for (const ClosestApproach& approach : record.approaches) {
    if (approach.to.starts_with("berg")) nearest = std::min(nearest, approach.distance_m);
  }
  return nearest;
}

/// The whole closed loop: flight model, sonar, ADCP, dead reckoning, mission files' orders and the system on board.
TEST(RandomIcebergs, AreSafeInTheClosedLoopWithTheSystemOn) {
  std::vector<double> ways_m;
  std::uint64_t collided_without = 0;
  for (std::uint64_t seed = first_seed(); seed < first_seed() + fields(); ++seed) {
    const IcebergField field = random_icebergs({}, start, departure, seed);
    const FlightRecord with = fly_through(field, seed, true);
    const FlightRecord without = fly_through(field, seed, false);
    if (without.end == FlightEnd::collided) ++collided_without;
    if (with.end == FlightEnd::arrived) ways_m.push_back(with.distance_m);
    std::cout << "seed " << seed << ": " << text(with.end) << " after " << with.duration().count()
              << " s and " << with.distance_m << " m, nearest " << nearest_m(with) << " m, "
              << with.end_reason << "; without: " << text(without.end) << std::endl;
    EXPECT_NE(with.end, FlightEnd::collided) << "seed " << seed << ": " << with.end_reason;
  }
  std::cout << fields() << " fields: " << ways_m.size() << " arrived, " << collided_without
            << " collided without the system\n";
  EXPECT_GE(static_cast<double>(ways_m.size()), 0.95 * static_cast<double>(fields()));
}

TEST(RandomIcebergs, AreTheSameForTheSameSeed) {
  const IcebergField one = random_icebergs({}, start, departure, 7);
  const IcebergField same = random_icebergs({}, start, departure, 7);
  const IcebergField other = random_icebergs({}, start, departure, 8);
  ASSERT_EQ(one.world.bodies().size(), same.world.bodies().size());
  const Body::Fix& fix = one.world.bodies().front().motion().track.back();
  EXPECT_EQ(fix.east_m, same.world.bodies().front().motion().track.back().east_m);
  EXPECT_NE(fix.east_m, other.world.bodies().front().motion().track.back().east_m);
}

/// Through the water no berg is faster than half the vehicle.
TEST(RandomIcebergs, AreWithinTheirSettings) {
  const IcebergFieldSettings settings;
  const IcebergField field = random_icebergs(settings, start, departure, 3);
  EXPECT_NEAR(static_cast<double>(field.world.bodies().size()), 66.0 / 1.5, 3.0);
  for (const Body& body : field.world.bodies()) {
    EXPECT_LE(body.shape().radius_m, settings.greatest_length.value);
    const Body::Fix& fix = body.motion().track.front();
    const Vector water =
        *field.world.current({fix.east_m, fix.north_m, 0.5 * body.shape().draft_m}, departure);
    const Vector through = body.velocity_at(departure + core::Seconds{1.0}) - water;
    EXPECT_LE(length(through), 0.5 * field.vehicle.speed_through_water.value + 0.03);
  }
}

}  // namespace
}  // namespace floeplan::simulation::random_icebergs_test

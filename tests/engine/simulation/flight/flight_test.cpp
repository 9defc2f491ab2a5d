#include "engine/simulation/flight/flight.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/vehicle/energy_model.hpp"
#include "tests/engine/simulation/flown.hpp"
#include "tests/support/property.hpp"

namespace floeplan::simulation::flight_test {
namespace {

using support::flight_origin;
using support::flight_start;
using support::flown;
using support::for_each_seed;
using support::orders_through;
using support::perfect_sensors;
using support::shallow_glider;
using support::uniform;
using support::uniform_water;

double level_distance(Vector a, Vector b) { return std::hypot(a.east - b.east, a.north - b.north); }

std::size_t count(const FlightRecord& record, EventKind kind) {
  return static_cast<std::size_t>(std::ranges::count(record.events, kind, &FlightEvent::kind));
}

Shape block(double half_m, double draft_m) {
  return {.parts = {ConvexPart{{{{1.0, 0.0, 0.0}, half_m},
                                {{-1.0, 0.0, 0.0}, half_m},
                                {{0.0, 1.0, 0.0}, half_m},
                                {{0.0, -1.0, 0.0}, half_m},
                                {{0.0, 0.0, 1.0}, draft_m},
                                {{0.0, 0.0, -1.0}, 10.0}}}},
          .radius_m = 1.5 * half_m,
          .draft_m = draft_m};
}

TEST(Flight, GoesStraightAndKnowsWhereItIsInStillWater) {
  const World world = uniform_water(0.0, 0.0);

  const FlightRecord record = flown(world, orders_through(world, {{3000.0, 0.0, 0.0}}), perfect_sensors());

  EXPECT_EQ(record.end, FlightEnd::arrived) << record.end_reason;
  for (const TrackPoint& point : record.track) {
    EXPECT_NEAR(point.position.north, 0.0, 15.0);
    EXPECT_NEAR(level_distance(point.position, point.believed), 0.0, 0.01);
  }
  EXPECT_NEAR(record.distance_m, 3000.0, 100.0);
  const auto glide = vehicle::steady_glide(shallow_glider().hydrodynamics, shallow_glider().pitch,
                                           shallow_glider().buoyancy);
  EXPECT_NEAR(record.duration().count(), 2950.0 / glide->horizontal.value, 600.0);
}

TEST(Flight, MeasuresAUniformCurrent) {
  const World world = uniform_water(0.08, -0.05);
  MissionOrders orders = orders_through(world, {{4000.0, 2000.0, 0.0}});
  SurfaceOrders hourly{.cause = SurfaceOrders::Cause::every,
                       .interval = core::Seconds{3600.0},
                       .wait = core::Seconds{300.0},
                       .climb = orders.yo.climb};
  orders.surfaces.insert(orders.surfaces.begin(), hourly);

  const FlightRecord record = flown(world, orders, perfect_sensors());

  EXPECT_EQ(record.end, FlightEnd::arrived) << record.end_reason;
  ASSERT_GE(record.sensors.fixes.size(), 2U);
  const FixEntry& last = record.sensors.fixes.back();
  EXPECT_NEAR(last.depth_averaged.east.value, 0.08, 0.002);
  EXPECT_NEAR(last.depth_averaged.north.value, -0.05, 0.002);
  // The second dive uses this current, so its dead-reckoning error is only the drift at the surface before
  // the first fix.
  const auto first_of_second = record.sensors.fixes[2];
  EXPECT_LT(level_distance(first_of_second.fixed, first_of_second.believed), 15.0);
}

TEST(Flight, ComesBackToWhereItStarted) {
  const World world = uniform_water(0.0, 0.0);
  const std::vector<Vector> square{{1500.0, 0.0, 0.0}, {1500.0, 1500.0, 0.0}, {0.0, 1500.0, 0.0}, {}};

  const FlightRecord record = flown(world, orders_through(world, square), perfect_sensors());

  EXPECT_EQ(record.end, FlightEnd::arrived);
  EXPECT_EQ(count(record, EventKind::waypoint), 4U);
  EXPECT_LT(length(record.track.back().position), 50.0 + 150.0);
}

TEST(Flight, AddsUpToItsVelocities) {
  const World world{
      {.origin = flight_origin,
       .bed = SeaBed{core::Metres{500.0}},
       .current = TrueCurrent{{0.05, 0.02, 0.0}, CurrentErrorField{{.rms = {0.1}}, flight_start, 4}}}};
  FlightSettings settings = perfect_sensors();
  settings.record_every = core::Seconds{1.0};

  const FlightRecord record = flown(world, orders_through(world, {{1500.0, 800.0, 0.0}}), settings);

  Vector sum{};
  for (std::size_t i = 1; i < record.track.size(); ++i) sum = sum + record.track[i].over_ground;
  EXPECT_NEAR(sum.east, record.track.back().position.east, 1e-6);
  EXPECT_NEAR(sum.north, record.track.back().position.north, 1e-6);
  EXPECT_NEAR(sum.down, record.track.back().position.down, 1e-6);
}

TEST(Flight, DrawsWhatTheEnergyModelSays) {
  const World world = uniform_water(0.0, 0.0);

  const FlightRecord record = flown(world, orders_through(world, {{4000.0, 0.0, 0.0}}), perfect_sensors());

  const vehicle::EnergyModel& model = shallow_glider().energy;
  const double teeth = 0.5 * static_cast<double>(count(record, EventKind::inflection));
  const double by_teeth_j =
      teeth * vehicle::tooth_energy(model, shallow_glider().buoyancy, {{5.0}, {100.0}}).value;
  const double expected_j = by_teeth_j + (model.hotel * record.duration()).value +
                            static_cast<double>(count(record, EventKind::surfacing)) * model.surfacing.value;
  EXPECT_GE(teeth, 3.0);
  EXPECT_NEAR(record.energy.value / expected_j, 1.0, 0.06);
}

TEST(Flight, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const World world = uniform_water(0.05, 0.0);
  const MissionOrders orders = orders_through(world, {{1000.0, 500.0, 0.0}});

  const FlightRecord once = flown(world, orders, {}, 5);

  EXPECT_EQ(flown(world, orders, {}, 5), once);
  EXPECT_NE(flown(world, orders, {}, 6), once);
}

TEST(Flight, StraysFromItsDeadReckoningAsTheErrorsSay) {
  const World world = uniform_water(0.0, 0.0);
  const MissionOrders orders = orders_through(world, {{1500.0, 0.0, 0.0}});
  constexpr int runs = 100;
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const FixEntry fix = flown(world, orders, {}, seed).sensors.fixes.front();
    squares += std::pow(level_distance(fix.fixed, fix.believed) / level_distance(fix.fixed, {}), 2);
  }

  // Biases of compass and speed together. The standard deviation from a hundred runs is accurate to 7 %.
  const NavigationErrors errors;
  EXPECT_NEAR(std::sqrt(squares / runs) / std::hypot(errors.compass.value, errors.speed_share), 1.0, 0.25);
}

TEST(Flight, IsOffItsDeadReckoningByTheWayOfTheWater) {
  // A first dive assumes still water.
  const World world{
      {.origin = flight_origin,
       .bed = {},
       .ice = {},
       .current = TrueCurrent{{0.03, 0.0, 0.0}, CurrentErrorField{{.rms = {0.05}}, flight_start, 9}},
       .bodies = {}}};
  FlightSettings settings = perfect_sensors();
  settings.record_every = core::Seconds{1.0};
  settings.longest = core::Seconds{3600.0};

  const FlightRecord record = flown(world, orders_through(world, {{5000.0, 0.0, 0.0}}), settings);

  Vector by_water{};
  for (std::size_t i = 0; i + 1 < record.track.size(); ++i)
    by_water = by_water + *world.current(record.track[i].position, record.track[i].time);
  const TrackPoint& last = record.track.back();
  EXPECT_NEAR(level_distance(last.position - by_water, last.believed), 0.0, 2.0);
}

TEST(Flight, KeepsItsAltitudeAboveTheSeaBed) {
  const World world{{.origin = flight_origin, .bed = SeaBed{core::Metres{60.0}}}};

  const FlightRecord record = flown(world, orders_through(world, {{1500.0, 0.0, 0.0}}), perfect_sensors());

  EXPECT_EQ(record.end, FlightEnd::arrived);
  ASSERT_FALSE(record.approaches.empty());
  EXPECT_EQ(record.approaches.front().to, "sea bed");
  EXPECT_NEAR(record.approaches.front().distance_m, 10.0 - 2.0, 2.0);
}

/// The altimeter's margin and the depth to climb to leave nothing in between.
TEST(Flight, IsAbortedWithoutDrainingItsBatteryWhereItIsTooShallowToDive) {
  const World world{{.origin = flight_origin, .bed = SeaBed{core::Metres{12.0}}}};
  MissionOrders orders = orders_through(world, {{5000.0, 0.0, 0.0}});
  orders.same_depth = core::Seconds{1800.0};

  const FlightRecord record = flown(world, orders, perfect_sensors());

  EXPECT_EQ(record.end, FlightEnd::gave_up);
  EXPECT_NE(record.end_reason.find("samedepth_for"), std::string::npos) << record.end_reason;
  EXPECT_LT(record.teeth, 70);
}

TEST(Flight, EndsAtAnIcebergOnItsWay) {
  WorldParts parts{.origin = flight_origin};
  parts.bodies.emplace_back("berg", block(60.0, 150.0), Body::Motion{.track = {{flight_start, 1000.0, 0.0}}});
  const World world{std::move(parts)};

  const FlightRecord record = flown(world, orders_through(world, {{2000.0, 0.0, 0.0}}), perfect_sensors());

  EXPECT_EQ(record.end, FlightEnd::collided) << record.end_reason;
  EXPECT_NEAR(record.track.back().position.east, 940.0, 2.0);
  ASSERT_EQ(record.approaches.size(), 1U);
  EXPECT_LE(record.approaches.front().distance_m, 0.75);
}

TEST(Flight, TellsHowNearItCameToWhatItPassed) {
  for_each_seed(10, [](std::mt19937_64& rng) {
    const double north_m = uniform(rng, 120.0, 300.0);
    WorldParts parts{.origin = flight_origin};
    parts.bodies.emplace_back("berg", block(60.0, 150.0),
                              Body::Motion{.track = {{flight_start, 700.0, north_m}}});
    const World world{std::move(parts)};
    FlightSettings settings = perfect_sensors();
    settings.record_every = core::Seconds{1.0};

    const FlightRecord record = flown(world, orders_through(world, {{1400.0, 0.0, 0.0}}), settings);

    double nearest_m = 1e9;
    const Body& berg = world.bodies().front();
    for (const TrackPoint& point : record.track)
      nearest_m = std::min(nearest_m, berg.distance(berg.pose_at(point.time), point.position));
    ASSERT_EQ(record.approaches.size(), 1U);
    EXPECT_NEAR(record.approaches.front().distance_m, nearest_m, 0.05);
  });
}

TEST(Flight, ComesUpForAFixBetweenOneListAndTheNext) {
  const World world = uniform_water(0.0, 0.0);
  MissionOrders orders = orders_through(world, {{2000.0, 0.0, 0.0}});
  orders.lists.push_back(orders_through(world, {{4000.0, 0.0, 0.0}, {5000.0, 500.0, 0.0}}).lists.front());
  orders.surfaces = {{.cause = SurfaceOrders::Cause::any_idle,
                      .ends_mission = true,
                      .climb = orders.surfaces.front().climb}};

  const FlightRecord record = flown(world, orders, perfect_sensors());

  EXPECT_EQ(record.end, FlightEnd::arrived) << record.end_reason;
  EXPECT_EQ(count(record, EventKind::surfacing), 2U);
  const auto first_up = std::ranges::find(record.events, EventKind::surfacing, &FlightEvent::kind);
  EXPECT_NEAR(first_up->position.east, 2000.0, 300.0);
  EXPECT_NE(std::ranges::find(first_up, record.events.end(), EventKind::fix, &FlightEvent::kind),
            record.events.end());
  EXPECT_NEAR(record.track.back().position.north, 500.0, 500.0);
}

TEST(Flight, GoesOnWithTheNextListAfterAnAbortForWantOfAHeading) {
  const World world = uniform_water(0.0, 0.0);
  MissionOrders orders = orders_through(world, {{2000.0, 0.0, 0.0}});
  orders.lists.push_back(orders_through(world, {{4000.0, 0.0, 0.0}}).lists.front());
  orders.surfaces.clear();

  const FlightRecord record = flown(world, orders, perfect_sensors());

  EXPECT_EQ(count(record, EventKind::surfacing), 2U);
  EXPECT_EQ(count(record, EventKind::waypoint), 2U);
  EXPECT_NEAR(record.track.back().position.east, 4000.0, 500.0);
}

TEST(Flight, DoesNotComeUpThroughIce) {
  const World world{{.origin = flight_origin, .ice = IceLayer{core::Metres{2.0}}}};
  MissionOrders orders = orders_through(world, {{500.0, 0.0, 0.0}});
  FlightRequest request{.world = world,
                        .orders = orders,
                        .vehicle = shallow_glider(),
                        .start = flight_origin,
                        .departure = flight_start};

  const core::Violations found = violations(request);

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().field, "/start");
}

TEST(Flight, RefusesAWorldThatDoesNotCoverItsMission) {
  const geo::LocalProjection projection{flight_origin};
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, ocean::Axis{{-52.1, -52.0, -51.9}},
                                   ocean::Axis{{47.4, 47.5, 47.6}}};
  const auto bathymetry =
      std::make_shared<const ocean::Bathymetry>(grid, std::vector<float>(grid.size(), 300.0F));
  const World world{
      {.origin = flight_origin, .bed = SeaBed{bathymetry, projection, {{-3e4, -3e4}, {3e4, 3e4}}}}};
  const MissionOrders orders = orders_through(world, {{2000.0, 0.0, 0.0}, {20'000.0, 0.0, 0.0}});
  FlightRequest request{.world = world,
                        .orders = orders,
                        .vehicle = shallow_glider(),
                        .start = flight_origin,
                        .departure = flight_start};
  request.settings.longest = core::Seconds{-1.0};

  const core::Violations found = violations(request);

  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].field, "/longest_s");
  EXPECT_EQ(found[1].field, "/files/list 1/row 2");
  EXPECT_THROW(Flight{request}, std::invalid_argument);
}

/// Currents of 0.1 m/s to the east for the given hours, on a grid about the origin.
World sea_for(int hours) {
  const geo::LocalProjection projection{flight_origin};
  const ocean::HorizontalGrid grid{geo::GeographicFrame{}, ocean::Axis{{-52.5, -52.0, -51.5}},
                                   ocean::Axis{{47.2, 47.5, 47.8}}};
  const double begin_s = core::unix_seconds(flight_start);
  const auto currents = std::make_shared<const ocean::CurrentGrid>(ocean::CurrentGrid::Samples{
      grid, std::nullopt, ocean::Axis{{begin_s, begin_s + 3600.0 * hours}},
      std::vector<float>(2 * grid.size(), 0.1F), std::vector<float>(2 * grid.size(), 0.0F)});
  return World{{.origin = flight_origin,
                .bed = {},
                .ice = {},
                .current = TrueCurrent{{currents, false}, projection, {}},
                .bodies = {}}};
}

TEST(Flight, RefusesDataThatEndLongBeforeItCouldArrive) {
  const World world = sea_for(2);
  const MissionOrders orders = orders_through(world, {{15'000.0, 0.0, 0.0}});

  const core::Violations found = violations({.world = world,
                                             .orders = orders,
                                             .vehicle = shallow_glider(),
                                             .start = flight_origin,
                                             .departure = flight_start});

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().field, "/departure");
}

TEST(Flight, EndsWhenTheDataEndOnItsWay) {
  const World world = sea_for(2);

  const FlightRecord record = flown(world, orders_through(world, {{4500.0, 0.0, 0.0}}), perfect_sensors());

  EXPECT_EQ(record.end, FlightEnd::left_data);
  EXPECT_NEAR(record.duration().count(), 7200.0, 2.0);
}

TEST(Flight, EndsWhenItsTimeIsUp) {
  const World world = uniform_water(0.0, 0.0);
  FlightSettings settings = perfect_sensors();
  settings.longest = core::Seconds{600.0};

  const FlightRecord record = flown(world, orders_through(world, {{3000.0, 0.0, 0.0}}), settings);

  EXPECT_EQ(record.end, FlightEnd::time_up);
  EXPECT_EQ(record.duration(), core::Seconds{600.0});
}

TEST(Flight, IsStoppedOnRequest) {
  const World world = uniform_water(0.0, 0.0);
  const MissionOrders orders = orders_through(world, {{3000.0, 0.0, 0.0}});
  std::stop_source source;
  source.request_stop();
  BareVehicle bare;

  const FlightRecord record = fly({.world = world,
                                   .orders = orders,
                                   .vehicle = shallow_glider(),
                                   .start = flight_origin,
                                   .departure = flight_start},
                                  bare, source.get_token());

  EXPECT_EQ(record.end, FlightEnd::stopped);
}

/// A system on board that always steers due north, and turns no deeper than 40 m.
struct NorthwardBoard {
  OnBoardAnswer step(const FlightView& /*view*/) const {
    OnBoardAnswer answer;
    answer.guidance.mode = avoidance::Mode::path;
    answer.guidance.reason = avoidance::Reason::evading;
    answer.guidance.heading = core::Radians{0.0};
    answer.guidance.deepest = core::Metres{40.0};
    return answer;
  }
};

TEST(Flight, IsGuidedByTheSystemOnBoard) {
  const World world = uniform_water(0.0, 0.0);
  const MissionOrders orders = orders_through(world, {{3000.0, 0.0, 0.0}});
  FlightSettings settings = perfect_sensors();
  settings.longest = core::Seconds{3600.0};
  NorthwardBoard board;

  const FlightRecord record = fly({.world = world,
                                   .orders = orders,
                                   .vehicle = shallow_glider(),
                                   .start = flight_origin,
                                   .departure = flight_start,
                                   .settings = settings},
                                  board);

  EXPECT_GT(record.track.back().position.north, 700.0);
  EXPECT_LT(std::abs(record.track.back().position.east), 30.0);
  for (const TrackPoint& point : record.track) EXPECT_LT(point.position.down, 44.0);
  EXPECT_EQ(count(record, EventKind::guidance), 1U);
}

/// A system on board that reports ice overhead for the first hour, 30 m deep with the margin.
struct IceOverhead {
  core::UtcTime until{};
  OnBoardAnswer step(const FlightView& view) const {
    OnBoardAnswer answer;
    if (view.truth.time < until) answer.guidance.shallowest = core::Metres{30.0};
    return answer;
  }
};

TEST(Flight, WaitsBelowTheIceThatTheSystemOnBoardKnowsWhenItIsToComeUp) {
  const World world = uniform_water(0.0, 0.0);
  MissionOrders orders = orders_through(world, {{5000.0, 0.0, 0.0}});
  orders.surfaces.push_back(
      {.cause = SurfaceOrders::Cause::every, .interval = core::Seconds{1200.0}, .climb = orders.yo.climb});
  IceOverhead board{flight_start + core::Seconds{3600.0}};

  const FlightRecord record = fly({.world = world,
                                   .orders = orders,
                                   .vehicle = shallow_glider(),
                                   .start = flight_origin,
                                   .departure = flight_start,
                                   .settings = perfect_sensors()},
                                  board);

  const auto up = std::ranges::find(record.events, EventKind::surfacing, &FlightEvent::kind);
  ASSERT_NE(up, record.events.end());
  EXPECT_GT(up->time, board.until);
  EXPECT_LT(up->time, board.until + core::Seconds{600.0});
  for (const TrackPoint& point : record.track) {
    const bool is_under = point.time > flight_start + core::Seconds{600.0} && point.time < board.until;
    EXPECT_TRUE(!is_under || point.position.down > 24.0) << point.position.down;
  }
}

}  // namespace
}  // namespace floeplan::simulation::flight_test

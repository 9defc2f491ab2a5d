#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "engine/mission/document/hold_order.hpp"
#include "engine/mission/reading/read_document.hpp"
#include "engine/mission/writing/mission_set.hpp"
#include "engine/motion/speed_over_ground.hpp"
#include "engine/simulation/flight/flight.hpp"
#include "engine/simulation/flight/flight_path.hpp"
#include "tests/engine/mission/random_plan.hpp"
#include "tests/engine/simulation/flown.hpp"
#include "tests/support/property.hpp"

namespace floeplan::simulation::hold_flight_test {
namespace {

using support::flight_origin;
using support::flight_start;
using support::for_each_seed;
using support::uniform;

/// A plan that holds, the vehicle for it, and the water that it is made for.
struct Scene {
  planning::Plan plan;
  vehicle::GliderProfile vehicle;
  std::shared_ptr<const ocean::CurrentGrid> water;
  core::Metres bed;
  geo::VelocityEn first;  // at the departure
};

constexpr core::Seconds hour{3600.0};

geo::Bearing random_bearing(std::mt19937_64& rng) { return geo::Bearing::degrees(uniform(rng, 0.0, 360.0)); }

/// The same everywhere, at each hour from the departure on.
std::shared_ptr<const ocean::CurrentGrid> water_of(const std::vector<geo::VelocityEn>& hourly) {
  std::vector<double> times_s;
  std::vector<float> u;
  std::vector<float> v;
  for (std::size_t i = 0; i < hourly.size(); ++i) {
    times_s.push_back(core::unix_seconds(flight_start + static_cast<double>(i) * hour));
    u.insert(u.end(), 4, static_cast<float>(hourly[i].east.value));
    v.insert(v.end(), 4, static_cast<float>(hourly[i].north.value));
  }
  return std::make_shared<const ocean::CurrentGrid>(ocean::CurrentGrid::Samples{
      .grid = ocean::HorizontalGrid{geo::GeographicFrame{}, ocean::Axis{{-53.0, -51.0}},
                                    ocean::Axis{{47.0, 48.0}}},
      .depths_m = std::nullopt,
      .times_s = ocean::Axis{times_s},
      .u = u,
      .v = v});
}

constexpr core::Seconds tide{12.42 * 3600.0};  // M2

/// When a vehicle that leaves at the start has covered this distance on its course.
core::UtcTime arrival_of(const std::vector<geo::VelocityEn>& hourly, core::MetresPerSecond speed,
                         geo::Bearing course, core::Metres length) {
  constexpr core::Seconds step{60.0};
  core::UtcTime time = flight_start;
  for (double done_m = 0.0; done_m < length.value; time += step) {
    const auto hours = static_cast<std::size_t>((time - flight_start) / hour);
    done_m += motion::speed_over_ground(speed, hourly.at(hours), course).value().value * step.count();
  }
  return time;
}

Scene random_scene(std::mt19937_64& rng, bool is_tide) {
  constexpr core::Metres leg{1500.0};
  Scene scene;
  scene.vehicle = *vehicle::find_profile("slocum-g3-200");
  scene.vehicle.dive_depth = {uniform(rng, 40.0, 150.0)};
  scene.bed = {uniform(rng, 60.0, 400.0)};
  const core::MetresPerSecond speed = scene.vehicle.speed_through_water;
  const double most_m_s = uniform(rng, 0.0, 0.8 * speed.value);
  const geo::Bearing set = random_bearing(rng);
  const double phase = uniform(rng, 0.0, 1.0);
  std::vector<geo::VelocityEn> hourly;
  for (int i = 0; i <= 72; ++i) {
    const double turn = 2.0 * std::numbers::pi * (i * hour / tide + phase);
    const double strength = is_tide ? most_m_s * std::sin(turn) : most_m_s;
    hourly.push_back({{strength * set.east()}, {strength * set.north()}});
  }
  scene.water = water_of(hourly);
  scene.first = hourly.front();
  const geo::Bearing course = random_bearing(rng);
  const geo::LonLat held = geo::geodesic_destination(flight_origin, course, leg);
  scene.plan =
      support::plan_of({flight_origin, held, geo::geodesic_destination(held, random_bearing(rng), {3000.0})});
  scene.plan.departure = flight_start;
  scene.plan.waypoints[0].eta = flight_start;
  scene.plan.waypoints[1].eta =
      arrival_of(hourly, speed, course, leg - core::Metres{100.0});  // where it is reached
  scene.plan.waypoints[1].wait = uniform(rng, 6.0, 12.0) * hour;
  scene.plan.arrival = scene.plan.waypoints[1].eta + scene.plan.waypoints[1].wait + 3.0 * hour;
  scene.plan.waypoints[2].eta = scene.plan.arrival;
  for (planning::Waypoint& waypoint : scene.plan.waypoints) waypoint.depth = scene.bed;
  return scene;
}

struct Flown {
  mission::HoldOrder order;
  core::UtcTime arrival;
  core::UtcTime release;
  double farthest_m{};  // from the place, meanwhile
  FlightRecord record;
};

Flown fly_hold(const Scene& scene, const FlightSettings& usual, std::uint64_t seed) {
  mission::MissionSetOptions options;
  options.vehicle = scene.vehicle;
  options.lists.holds.currents = mission::hold_currents({.currents = scene.water}, scene.plan, scene.vehicle);
  const auto set = mission::write_mission_set(scene.plan, options).value();
  Flown flown;
  std::vector<mission::Document> documents;
  for (const mission::MissionFile& file : set.files) {
    documents.push_back(mission::read_document(file.name, file.text));
    if (const auto order = mission::hold_order(documents.back())) flown.order = *order;
  }
  const MissionOrders orders = read_orders(documents, scene.vehicle).value();
  const World world{{.origin = flight_origin,
                     .bed = SeaBed{scene.bed},
                     .current = TrueCurrent{{.grid = scene.water, .steady = false},
                                            geo::LocalProjection{flight_origin},
                                            CurrentErrorField{}}}};
  FlightSettings settings = usual;
  settings.known_current = scene.first;
  Flight flight{{.world = world,
                 .orders = orders,
                 .vehicle = flown_vehicle(scene.vehicle).value(),
                 .start = flight_origin,
                 .departure = flight_start,
                 .settings = settings,
                 .seed = seed}};
  const std::size_t goal = flight_path(world, orders, flight_origin).stops.size() - 1;
  BareVehicle bare;
  while (flight.is_under_way()) {
    const FlightView view = flight.view();
    if (view.waypoint == 0) flown.arrival = view.truth.time;
    if (view.waypoint < goal) flown.release = view.truth.time;
    flight.step(bare.step(view));
  }
  flown.record = flight.take_record();
  const Vector held = world.to_frame(scene.plan.waypoints[1].place);
  for (const TrackPoint& point : flown.record.track)
    if (point.time > flown.arrival && point.time < flown.release)
      flown.farthest_m = std::max(
          flown.farthest_m, std::hypot(point.position.east - held.east, point.position.north - held.north));
  return flown;
}

double share_of_wait(const Scene& scene, const Flown& flown) {
  return (flown.release - flown.arrival) / scene.plan.waypoints[1].wait;
}

/// Law: with sensors that do not err, a hold lasts within a tenth as long as planned, in any current that lets the
/// vehicle hold. In one that stays as it is the vehicle keeps near its circle; a tide turns while it reckons with the current
/// of the dive before.
void hold_as_planned(std::uint64_t seeds, bool is_tide) {
  std::uint64_t seed = 0;
  for_each_seed(seeds, [&](std::mt19937_64& rng) {
    const Scene scene = random_scene(rng, is_tide);

    const Flown flown = fly_hold(scene, support::perfect_sensors(), ++seed);

    EXPECT_EQ(flown.record.end, FlightEnd::arrived) << flown.record.end_reason;
    EXPECT_NEAR(share_of_wait(scene, flown), 1.0, 0.1);
    if (!is_tide) {
      EXPECT_LT(flown.farthest_m, 1.5 * planning::HoldRules{}.radius.value);
    }
  });
}

TEST(HoldFlight, LastsAsLongAsPlannedInACurrent) { hold_as_planned(6, false); }

TEST(HoldFlight, LastsAsLongAsPlannedInATide) { hold_as_planned(6, true); }

TEST(HoldFlight, LastsAsLongAsPlannedInAnyWater) {
  hold_as_planned(60, false);
  hold_as_planned(60, true);
}

/// A glider knows its speed to some 5 % and its heading to 2 degrees. Its legs end earlier or later by such
/// errors.
TEST(HoldFlight, LastsMostlyAsLongAsPlannedWhateverTheSensorsErr) {
  int within = 0;
  constexpr int flights = 40;
  std::mt19937_64 rng{1};
  for (int flight = 1; flight <= flights; ++flight) {
    const Scene scene = random_scene(rng, flight % 2 == 0);
    const double share = share_of_wait(scene, fly_hold(scene, {}, static_cast<std::uint64_t>(flight)));
    EXPECT_NEAR(share, 1.0, 0.3) << "flight " << flight;
    if (std::abs(share - 1.0) <= 0.1) ++within;
  }
  EXPECT_GE(within, flights * 3 / 4);
}

TEST(HoldFlight, EndsAListWithoutEndWhereItsCommentSays) {
  std::mt19937_64 rng{3};
  Scene scene = random_scene(rng, false);
  const core::Seconds longer = 30.0 * hour - scene.plan.waypoints[1].wait;
  scene.plan.waypoints[1].wait += longer;
  scene.plan.waypoints[2].eta += longer;

  const Flown flown = fly_hold(scene, support::perfect_sensors(), 3);

  EXPECT_EQ(flown.order.legs, -1);
  EXPECT_EQ(flown.record.end, FlightEnd::arrived) << flown.record.end_reason;
  EXPECT_NEAR(share_of_wait(scene, flown), 1.0, 0.1);
}

}  // namespace
}  // namespace floeplan::simulation::hold_flight_test

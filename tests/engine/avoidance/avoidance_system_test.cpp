#include "engine/avoidance/avoidance_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "engine/avoidance/steering.hpp"
#include "tests/support/property.hpp"

namespace floeplan::avoidance::avoidance_system_test {
namespace {

constexpr double start_s = 1e9;

std::unique_ptr<AvoidanceSystem> system_to(geo::PlanePoint goal, AvoidanceSettings settings = {}) {
  return std::make_unique<AvoidanceSystem>(std::vector<geo::PlanePoint>{goal},
                                           CarriedForecast{geo::VelocityEn{}}, settings);
}

OwnState own_at(double second, geo::PlanePoint place, double heading_rad = std::numbers::pi / 2.0) {
  OwnState own;
  own.time = core::from_unix_seconds(start_s + second);
  own.place = place;
  own.depth = core::Metres{20.0};
  own.attitude.heading = core::Radians{heading_rad};
  own.through_water = core::MetresPerSecond{0.35};
  return own;
}

/// Echoes of a wall across the way to the east, from `low_m` to `high_m` north.
std::vector<SonarReturn> wall_ahead(double ahead_m, double low_m, double high_m) {
  std::vector<SonarReturn> returns;
  for (double north = low_m; north <= high_m; north += 4.0) {
    const double range = std::hypot(ahead_m, north);
    returns.push_back({core::Metres{range}, {ahead_m / range, -north / range, 0.0}, 90.0});
  }
  return returns;
}

/// Swims east towards a standing wall for some seconds; the guidance of each.
std::vector<Guidance> towards_wall(AvoidanceSystem& system, double wall_m, int seconds, bool plans) {
  std::vector<Guidance> guided;
  for (int second = 0; second < seconds; ++second) {
    Sensed sensed{.own = own_at(second, {0.35 * second, 0.0})};
    const auto returns = wall_ahead(wall_m - 0.35 * second, -40.0, 60.0);
    sensed.sonar = SonarPing{sensed.own.time, returns};
    guided.push_back(plans ? system.step(sensed) : system.react(sensed));
  }
  return guided;
}

TEST(AvoidanceSystem, RefusesSettingsAndMissionsThatCannotBe) {
  AvoidanceSettings settings;
  settings.clearance = core::Metres{-1.0};
  EXPECT_THROW(system_to({1000.0, 0.0}, settings), std::invalid_argument);
  EXPECT_THROW(system_to({std::nan(""), 0.0}), std::invalid_argument);
}

TEST(AvoidanceSystem, LeavesTheMissionAloneInAnEmptySea) {
  const auto system = system_to({1000.0, 0.0});
  for (int second = 0; second < 300; ++second) {
    const Guidance guided = system->step({.own = own_at(second, {0.35 * second, 0.0})});
    EXPECT_EQ(guided, (Guidance{}));
  }
}

TEST(AvoidanceSystem, EvadesByAPathInTime) {
  const auto system = system_to({1000.0, 0.0});
  const auto guided = towards_wall(*system, 180.0, 20, true);
  EXPECT_EQ(guided.front().mode, Mode::mission);
  EXPECT_EQ(guided.back().mode, Mode::path);
  EXPECT_EQ(guided.back().reason, Reason::evading);
  ASSERT_TRUE(guided.back().heading);
  EXPECT_GT(std::sin(guided.back().heading->value), 0.0);  // still eastward,
  EXPECT_LT(std::cos(guided.back().heading->value), 0.0);  // round the nearer, southern end
  EXPECT_EQ(system->counters().evasions, 1);
}

TEST(AvoidanceSystem, ReactsAtOnceWhileThereIsNoPath) {
  const auto system = system_to({1000.0, 0.0});
  const auto guided = towards_wall(*system, 180.0, 20, false);
  EXPECT_EQ(guided.back().mode, Mode::reactive);
  EXPECT_EQ(guided.back().reason, Reason::path_not_ready);
  EXPECT_TRUE(system->path_wanted());
  ASSERT_TRUE(guided.back().heading);
}

TEST(AvoidanceSystem, ReactsToWhatIsTooCloseEvenWithAPath) {
  const auto system = system_to({1000.0, 0.0});
  const auto guided = towards_wall(*system, 24.0, 10, true);
  EXPECT_EQ(guided.back().mode, Mode::reactive);
  EXPECT_EQ(guided.back().reason, Reason::too_close);
  EXPECT_TRUE(guided.back().thruster);
}

TEST(AvoidanceSystem, ReturnsToTheMissionWhenTheRouteIsClear) {
  const auto system = system_to({1000.0, 0.0});
  (void)towards_wall(*system, 180.0, 20, true);
  ASSERT_EQ(system->mode(), Mode::path);

  // A time after which an object that is no longer seen is forgotten.
  const double forgotten_s =
      20.0 + AvoidanceSettings{}.forget.count() + AvoidanceSettings{}.settled.count() + 5.0;
  Guidance guided;
  for (int second = 20; second < forgotten_s; ++second)
    guided = system->step({.own = own_at(second, {7.0, 0.0})});
  EXPECT_EQ(guided.reason, Reason::route_clear);
  EXPECT_EQ(guided.mode, Mode::mission);
}

TEST(AvoidanceSystem, GivesUpWithAReasonAndStaysSo) {
  AvoidanceSettings settings;
  settings.give_up = core::Seconds{120.0};
  const auto system = system_to({1000.0, 0.0}, settings);
  Guidance guided;
  for (int second = 0; second < 200; ++second) {  // the vehicle makes no progress
    Sensed sensed{.own = own_at(second, {0.0, 0.0})};
    sensed.own.through_water = core::MetresPerSecond{0.0};
    const auto returns = wall_ahead(60.0, -190.0, 190.0);
    sensed.sonar = SonarPing{sensed.own.time, returns};
    guided = system->step(sensed);
  }
  EXPECT_EQ(guided.mode, Mode::given_up);
  EXPECT_EQ(guided.reason, Reason::no_progress);
}

TEST(AvoidanceSystem, SteersNothingAtTheSurface) {
  const auto system = system_to({1000.0, 0.0});
  Sensed sensed{.own = own_at(0.0, {0.0, 0.0})};
  sensed.own.at_surface = true;
  const Guidance guided = system->step(sensed);
  EXPECT_EQ(guided.reason, Reason::at_surface);
  EXPECT_FALSE(guided.heading);
}

TEST(AvoidanceSystem, HoldsWhatItSaidWhileTheOwnStateIsUnusable) {
  const auto system = system_to({1000.0, 0.0});
  const Guidance said = towards_wall(*system, 180.0, 20, true).back();
  OwnState broken = own_at(21.0, {7.0, 0.0});
  broken.attitude.heading = core::Radians{std::nan("")};
  for (const OwnState& own : {broken, own_at(3.0, {7.0, 0.0})}) {
    const Guidance held = system->step({.own = own});
    EXPECT_EQ(held.reason, Reason::own_state_unusable);
    EXPECT_EQ(held.mode, said.mode);
    EXPECT_EQ(held.heading, said.heading);
  }
  EXPECT_EQ(system->step({.own = own_at(22.0, {7.7, 0.0})}).mode, said.mode);
}

TEST(AvoidanceSystem, ReportsObjectsInTheFlightsPlane) {
  const auto system = system_to({1000.0, 0.0});
  (void)towards_wall(*system, 150.0, 20, true);
  const auto objects = system->objects();
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_NEAR(objects[0].centre.x_m, 150.0, 3.0);
  EXPECT_NEAR(objects[0].centre.y_m, 10.0, 8.0);
  EXPECT_NEAR(objects[0].half_extent.value, 50.0, 6.0);
  EXPECT_NEAR(objects[0].drift.east.value, 0.0, 0.1);
}

/// Law: the same input gives the same answers, and every answer has a finite heading within its range,
/// whatever the sensors measure.
TEST(AvoidanceSystem, HoldsAgainstSensorsThatTellNonsense) {
  support::for_each_seed(10, [](std::mt19937_64& rng) {
    const auto system = system_to({1000.0, 0.0});
    const auto twin = system_to({1000.0, 0.0});
    const auto any = [&] {
      const double v = support::uniform(rng, -300.0, 300.0);
      const int which = support::uniform_int(rng, 0, 19);
      return which == 0   ? std::nan("")
             : which == 1 ? std::numeric_limits<double>::infinity()
             : which == 2 ? 0.0
                          : v;
    };
    std::vector<SonarReturn> returns(600);
    for (int second = 0; second < 40; ++second) {
      for (SonarReturn& echo : returns)
        echo = {core::Metres{any()}, {any() / 300.0, any() / 300.0, any() / 300.0}, any()};
      std::vector<CurrentBin> bins{{core::Metres{any()}, {{any()}, {any()}}, core::MetresPerSecond{any()}}};
      Sensed sensed{.own = own_at(second, {0.35 * second, 0.0})};
      sensed.own.altitude = core::Metres{any()};
      sensed.sonar = SonarPing{sensed.own.time, returns};
      sensed.current = CurrentProfile{sensed.own.time, bins};
      const Guidance guided = system->step(sensed);
      EXPECT_EQ(guided, twin->step(sensed));
      if (guided.heading) {
        EXPECT_TRUE(std::isfinite(guided.heading->value));
      }
      EXPECT_TRUE(std::isfinite(system->current().velocity.east.value));
    }
  });
}

}  // namespace
}  // namespace floeplan::avoidance::avoidance_system_test

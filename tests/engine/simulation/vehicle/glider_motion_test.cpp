#include "engine/simulation/vehicle/glider_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/property.hpp"

namespace floeplan::simulation::glider_motion_test {
namespace {

using support::for_each_seed;
using support::uniform;

constexpr double deep_m = 50.0;

vehicle::GliderProfile profile() { return *vehicle::find_profile("slocum-g3-200"); }

TEST(GliderMotion, SettlesIntoTheSteadyGlide) {
  for_each_seed(50, [](std::mt19937_64& rng) {
    const double pitch_rad = uniform(rng, 0.3, 0.7);
    const double buoyancy_m3 = uniform(rng, 100e-6, 260e-6);
    const double sign = uniform(rng, -1.0, 1.0) < 0.0 ? -1.0 : 1.0;
    GliderMotion motion{profile(), HullMotion{}, 0.0};

    for (int i = 0; i < 300; ++i)
      motion.advance({.pitch_rad = sign * pitch_rad, .buoyancy_m3 = sign * buoyancy_m3}, deep_m);

    const auto steady = vehicle::steady_glide(profile().hydrodynamics, {pitch_rad}, {buoyancy_m3});
    ASSERT_TRUE(steady.has_value());
    EXPECT_NEAR(motion.horizontal_m_s() / steady->horizontal.value, 1.0, 0.01);
    EXPECT_NEAR(-sign * motion.sinking_m_s() / steady->vertical.value, 1.0, 0.01);
  });
}

TEST(GliderMotion, TurnsWithinItsRadiusAndStopsOnItsHeading) {
  GliderMotion motion{profile(), HullMotion{}, 0.0};
  ActuatorTargets targets{.pitch_rad = -0.45, .buoyancy_m3 = -230e-6, .heading_rad = 0.0};
  for (int i = 0; i < 100; ++i) motion.advance(targets, deep_m);

  targets.heading_rad = 0.5 * std::numbers::pi;
  double turned_fastest_rad = 0.0;
  double most_rad = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double before = motion.attitude().heading_rad;
    motion.advance(targets, deep_m);
    turned_fastest_rad = std::max(turned_fastest_rad, motion.attitude().heading_rad - before);
    most_rad = std::max(most_rad, motion.attitude().heading_rad);
  }

  EXPECT_LE(turned_fastest_rad, motion.horizontal_m_s() / HullMotion{}.turn_radius.value);
  EXPECT_NEAR(motion.attitude().heading_rad, targets.heading_rad, 0.01);
  EXPECT_LT(most_rad - targets.heading_rad, 0.1);
}

TEST(GliderMotion, OvershootsItsTurnByMetresAsTheRealOneDoes) {
  // Log of comet (21 August 2019): when the piston begins to move at 38.8 m, the deepest point follows at 40.5 m.
  // Its battery stays where it is; here the servo brings the nose up at once, and that brakes.
  GliderMotion motion{profile(), HullMotion{}, 0.0};
  double depth_m = 0.0;
  while (depth_m < 38.8) {
    motion.advance({.pitch_rad = -0.44, .buoyancy_m3 = -230e-6}, depth_m);
    depth_m += motion.sinking_m_s();
  }
  double deepest_m = depth_m;
  for (int i = 0; i < 60; ++i) {
    motion.advance({.pitch_rad = 0.44, .buoyancy_m3 = 230e-6}, depth_m);
    depth_m += motion.sinking_m_s();
    deepest_m = std::max(deepest_m, depth_m);
  }

  EXPECT_NEAR(deepest_m, 40.5, 1.0);
}

TEST(GliderMotion, FloatsAtTheSurfaceWhileItIsLight) {
  GliderMotion motion{profile(), HullMotion{}, 1.0};

  for (int i = 0; i < 50; ++i) motion.advance({.buoyancy_m3 = 230e-6, .heading_rad = 2.0}, 0.0);

  EXPECT_EQ(motion.through_water(), Vector{});
}

TEST(GliderMotion, IsDrivenByTheThrusterToTheSpeedAskedFor) {
  GliderMotion motion{profile(), HullMotion{}, 0.0};
  for (int i = 0; i < 200; ++i)
    motion.advance({.pitch_rad = -0.45, .buoyancy_m3 = -230e-6, .thruster_speed_m_s = 0.6}, deep_m);

  EXPECT_NEAR(motion.horizontal_m_s(), 0.6, 0.01);
}

/// Law: with its pump and pitch the simulated vehicle has the speed that plans assume.
TEST(FlownVehicle, MakesTheSpeedOfItsProfile) {
  for (const vehicle::GliderProfile& known : vehicle::known_profiles()) {
    const auto flown = flown_vehicle(known);

    ASSERT_TRUE(flown.has_value()) << known.name;
    const auto glide = vehicle::steady_glide(flown->hydrodynamics, known.pitch, known.buoyancy);
    EXPECT_NEAR(glide->horizontal.value, known.speed_through_water.value, 1e-6) << known.name;
    EXPECT_NEAR(flown->hydrodynamics.parasite_drag, 0.13, 0.02) << known.name;
  }
}

TEST(FlownVehicle, IsNoneWhereNoDragExplainsTheSpeed) {
  vehicle::GliderProfile profile = vehicle::known_profiles().front();
  profile.speed_through_water = {2.0};
  EXPECT_FALSE(flown_vehicle(profile).has_value());
}

TEST(HullMotion, NamesEveryValueOutOfRange) {
  HullMotion hull;
  EXPECT_TRUE(hull.violations().empty());

  hull.mass_kg = std::nan("");
  hull.turn_radius = {0.0};
  EXPECT_EQ(hull.violations().size(), 2U);
}

}  // namespace
}  // namespace floeplan::simulation::glider_motion_test

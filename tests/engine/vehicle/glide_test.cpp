#include "engine/vehicle/glide.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/vehicle/sea_water.hpp"
#include "tests/support/property.hpp"

namespace floeplan::vehicle::glide_test {
namespace {

constexpr core::Radians pitch_deg(double degrees) { return {core::degrees_to_radians(degrees)}; }

TEST(Hydrodynamics, HasTheDefaultsThatItsSourceComputes) {
  const double aspect = 7.0;
  const double tangent = std::tan(core::degrees_to_radians(43.0));
  const double wing_lift =
      2.0 * std::numbers::pi * aspect / (2.0 + std::sqrt(aspect * aspect * (1.0 + tangent * tangent) + 4.0));
  const Hydrodynamics h;

  EXPECT_NEAR(h.lift_slope, 3.8 + wing_lift, 0.005);
  EXPECT_NEAR(h.induced_drag, 9.7 + wing_lift * wing_lift / (std::numbers::pi * 0.8 * aspect), 0.01);
}

// Angle of attack and speeds from the same balance of forces, solved by an independent program.
TEST(SteadyGlide, HasTheSpeedOfTheBalanceAt26Degrees) {
  const auto glide = steady_glide({}, pitch_deg(26.0), {230e-6});

  ASSERT_TRUE(glide.has_value());
  EXPECT_NEAR(core::radians_to_degrees(glide->angle_of_attack.value), 2.365, 0.001);
  EXPECT_NEAR(glide->horizontal.value, 0.3144, 1e-4);
  EXPECT_NEAR(glide->vertical.value, 0.1698, 1e-4);
}

// Dives and climbs of two shallow Slocums that moved 230 cm3 to either side, from their public logs: comet in
// August 2019 (github.com/smerckel/glidersim), pitch 25.7 and 25.3 degrees, 0.160 and 0.130 m/s; amadeus in
// July 2014 (github.com/smerckel/dbdreader), pitch 22.9 and 23.4 degrees, 0.096 and 0.198 m/s. Their trim
// makes the difference of dive and climb; in the mean of the squares, which the buoyancy is proportional to,
// it cancels.
TEST(SteadyGlide, SinksAndRisesAsLoggedVehiclesWithin15PerCent) {
  const auto comet = steady_glide({}, pitch_deg(25.5), {230e-6});
  const auto amadeus = steady_glide({}, pitch_deg(23.15), {230e-6});

  ASSERT_TRUE(comet && amadeus);
  const double logged_comet = std::sqrt((0.160 * 0.160 + 0.130 * 0.130) / 2.0);
  const double logged_amadeus = std::sqrt((0.096 * 0.096 + 0.198 * 0.198) / 2.0);
  EXPECT_NEAR(comet->vertical.value, logged_comet, 0.15 * logged_comet);
  EXPECT_NEAR(amadeus->vertical.value, logged_amadeus, 0.15 * logged_amadeus);
}

TEST(SteadyGlide, BalancesTheForcesInBothDirections) {
  support::for_each_seed(200, [](std::mt19937_64& rng) {
    const Hydrodynamics h{.parasite_drag = support::uniform(rng, 0.05, 0.3),
                          .induced_drag = support::uniform(rng, 2.0, 12.0),
                          .lift_slope = support::uniform(rng, 4.0, 9.0),
                          .area_m2 = support::uniform(rng, 0.05, 0.2)};
    const core::Radians pitch = pitch_deg(support::uniform(rng, 18.0, 60.0));
    const core::CubicMetres buoyancy{support::uniform(rng, 5e-5, 1e-3)};

    const auto glide = steady_glide(h, pitch, buoyancy);

    ASSERT_TRUE(glide.has_value());
    const double speed2 = std::pow(glide->horizontal.value, 2) + std::pow(glide->vertical.value, 2);
    const double pressure = 0.5 * sea_water_density_kg_m3 * speed2 * h.area_m2;
    const double attack = glide->angle_of_attack.value;
    const double lift_n = pressure * h.lift_slope * attack;
    const double drag_n = pressure * (h.parasite_drag + h.induced_drag * attack * attack);
    const double path = glide->path_angle.value;
    const double weight_n = sea_water_density_kg_m3 * gravity_m_s2 * buoyancy.value;
    EXPECT_NEAR(lift_n * std::sin(path), drag_n * std::cos(path), 1e-9 * weight_n);
    EXPECT_NEAR(lift_n * std::cos(path) + drag_n * std::sin(path), weight_n, 1e-9 * weight_n);
  });
}

TEST(SteadyGlide, IsFasterWithMoreBuoyancyAndSinksFasterWithMorePitch) {
  const auto slow = steady_glide({}, pitch_deg(26.0), {230e-6});
  const auto fast = steady_glide({}, pitch_deg(26.0), {260e-6});
  const auto steep = steady_glide({}, pitch_deg(35.0), {230e-6});

  EXPECT_GT(fast->horizontal, slow->horizontal);
  EXPECT_GT(steep->vertical, slow->vertical);
}

TEST(SteadyGlide, DoesNotExistWithoutEnoughLift) {
  EXPECT_FALSE(steady_glide({.lift_slope = 0.1}, pitch_deg(10.0), {230e-6}).has_value());
}

}  // namespace
}  // namespace floeplan::vehicle::glide_test

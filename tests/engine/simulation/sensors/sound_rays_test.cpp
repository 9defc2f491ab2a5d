#include "engine/simulation/sensors/sound_rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "engine/core/random.hpp"
#include "engine/simulation/sensors/altimeter.hpp"

namespace floeplan::simulation::sound_rays_test {
namespace {

World flat_world(double bed_m, double draft_m = 0.0) {
  WorldParts parts;
  parts.bed = SeaBed{core::Metres{bed_m}};
  if (draft_m > 0.0) parts.ice = IceLayer{core::Metres{draft_m}};
  return World{std::move(parts)};
}

TEST(SoundRays, MeetAFlatBedWhereGeometrySays) {
  const World world = flat_world(100.0);
  SoundRays rays{world, core::Metres{200.0}};
  const Vector place{10.0, 20.0, 60.0};
  rays.look_from(place, {});

  const auto hit = rays(place, {0.6, 0.0, 0.8}, 200.0);

  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->range_m, 50.0, 0.05);
  EXPECT_NEAR(hit->cosine, 0.8, 1e-9);
  EXPECT_EQ(hit->scatterer, Scatterer::sea_bed);
}

TEST(SoundRays, MeetTheOpenSurfaceOrTheIceAboveThem) {
  const Vector place{0.0, 0.0, 40.0};
  const World open = flat_world(300.0);
  SoundRays to_surface{open, core::Metres{100.0}};
  to_surface.look_from(place, {});
  const World covered = flat_world(300.0, 5.0);
  SoundRays to_ice{covered, core::Metres{100.0}};
  to_ice.look_from(place, {});

  const auto surface = to_surface(place, {0.0, 0.6, -0.8}, 100.0);
  const auto ice = to_ice(place, {0.0, 0.6, -0.8}, 100.0);

  ASSERT_TRUE(surface && ice);
  EXPECT_EQ(surface->scatterer, Scatterer::open_surface);
  EXPECT_NEAR(surface->range_m, 50.0, 1e-9);
  EXPECT_EQ(ice->scatterer, Scatterer::ice);
  EXPECT_NEAR(ice->range_m, 35.0 / 0.8, 1e-9);
  EXPECT_FALSE(to_ice(place, {0.0, 1.0, 0.0}, 100.0).has_value());
}

AltimeterSettings exact() {
  AltimeterSettings settings;
  settings.range_sigma_m = 0.0;
  return settings;
}

TEST(Altimeter, SeesTheBedStraightBelowADivingVehicle) {
  const World world = flat_world(100.0);
  const Altimeter altimeter{exact()};
  SoundRays rays{world, core::Metres{100.0}};
  TrueState state;
  state.position = {0.0, 0.0, 70.0};
  state.attitude.pitch_rad = -altimeter.settings().forward_cant_rad;
  rays.look_from(state.position, state.time);
  auto rng = core::random_stream(1, "altimeter");

  const auto echo = altimeter.ping(state, rays, rng);

  ASSERT_TRUE(echo.has_value());
  EXPECT_NEAR(echo->altitude_m, 30.0, 0.05);
}

TEST(Altimeter, IsSilentAboveABedOutOfItsRangeAndUnderneathTheOpenSurface) {
  const World world = flat_world(400.0);
  const Altimeter altimeter{exact()};
  SoundRays rays{world, core::Metres{100.0}};
  TrueState state;
  state.position = {0.0, 0.0, 70.0};
  rays.look_from(state.position, state.time);
  auto rng = core::random_stream(2, "altimeter");

  EXPECT_FALSE(altimeter.ping(state, rays, rng).has_value());
}

TEST(Altimeter, AnswersAnythingAsOftenAsItIsToldTo) {
  AltimeterSettings settings = exact();
  settings.false_echo_share = 0.1;
  const Altimeter altimeter{settings};
  const auto nothing = [](Vector, Vector, double) -> std::optional<RayHit> { return std::nullopt; };
  auto rng = core::random_stream(3, "altimeter");
  int echoes = 0;
  for (int ping = 0; ping < 10'000; ++ping) echoes += altimeter.ping(TrueState{}, nothing, rng) ? 1 : 0;

  EXPECT_NEAR(echoes, 1000, 150);
}

TEST(Altimeter, RefusesNonsense) {
  AltimeterSettings settings;
  settings.range_m = 1.0;
  settings.width_rad = 3.0;

  EXPECT_EQ(settings.violations().size(), 2U);
  EXPECT_THROW(Altimeter{settings}, std::invalid_argument);
}

}  // namespace
}  // namespace floeplan::simulation::sound_rays_test

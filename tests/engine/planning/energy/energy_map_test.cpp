#include "engine/planning/energy/energy_map.hpp"

#include <gtest/gtest.h>

#include "tests/support/property.hpp"
#include "tests/support/small_sea.hpp"

namespace floeplan::planning::energy::energy_map_test {
namespace {

using vehicle::Drive;

const geo::LocalProjection projection{{-53.0, 69.0}};
const plane::PlaneBox area{{-30'000.0, -30'000.0}, {30'000.0, 30'000.0}};

vehicle::GliderProfile hybrid() { return vehicle::find_profile("slocum-g3-200-thruster").value(); }

EnergyMap map_over(const std::shared_ptr<const ocean::Bathymetry>& bathymetry,
                   const vehicle::GliderProfile& profile = hybrid()) {
  return {profile, currents::FlownDepths{profile.dive_limits(), bathymetry}, projection, area, {}};
}

TEST(EnergyMap, AddsUpTheEnergyOfADeepLegByHand) {
  const vehicle::GliderProfile profile = hybrid();

  const EnergyUse use =
      map_over(nullptr).use({0.0, 0.0}, {10'000.0, 0.0}, core::Seconds{36'000.0}, Drive::buoyancy);

  // 0.35 m/s along a path of 28.36 degrees: 0.189 m/s, 34.9 teeth of 195 m down and up.
  const double changed_m = profile.vertical_speed({0.35}).value * 36'000.0;
  const double teeth = changed_m / (2.0 * 195.0);
  EXPECT_NEAR(teeth, 17.4, 0.1);
  EXPECT_NEAR(use.hotel.value, 1.16 * 36'000.0, 1e-6);
  EXPECT_NEAR(use.inflections, 2.0 * teeth, 1e-4);
  const double a_tooth_j = (2.49 + 0.18) * 460.0 + 1027.7 * 9.81 * 200.0 * 460e-6 / 0.82 + 1080.0;
  EXPECT_NEAR(use.pump.value, teeth * a_tooth_j, 1e-5 * use.pump.value);
  EXPECT_EQ(use.thruster.value, 0.0);
}

TEST(EnergyMap, AddsTheThrusterOnItsOwnDrive) {
  const EnergyMap map = map_over(nullptr);

  const EnergyUse use = map.use({0.0, 0.0}, {5000.0, 0.0}, core::Seconds{1000.0}, Drive::thruster);

  EXPECT_NEAR(use.thruster.value, 1000.0 * hybrid().thruster->power.value, 1e-9);
  EXPECT_GT(use.inflections,
            map.use({0.0, 0.0}, {5000.0, 0.0}, core::Seconds{1000.0}, Drive::buoyancy).inflections);
}

TEST(EnergyMap, CostsMoreOverABank) {
  const EnergyMap map =
      map_over(support::bathymetry_from([](geo::LonLat p) { return p.lon_deg < -53.0 ? 30.0 : 400.0; }));
  const core::Seconds time{3600.0};

  const EnergyUse bank = map.use({-20'000.0, 0.0}, {-19'000.0, 0.0}, time, Drive::buoyancy);
  const EnergyUse deep = map.use({19'000.0, 0.0}, {20'000.0, 0.0}, time, Drive::buoyancy);

  EXPECT_FALSE(map.is_even());
  EXPECT_EQ(bank.hotel, deep.hotel);
  EXPECT_NEAR(bank.inflections / deep.inflections, 195.0 / 15.0, 1e-3);
  EXPECT_GT(bank.pump, deep.pump);
}

TEST(EnergyMap, IsEvenWhereTheSeaBedIsOutOfReach) {
  EXPECT_TRUE(map_over(nullptr).is_even());
  EXPECT_TRUE(map_over(support::bathymetry_from([](geo::LonLat) { return 210.0; })).is_even());
}

TEST(EnergyMap, IsNeverBelowItsLeastPowerAndAddsUpOverTheParts) {
  const EnergyMap map = map_over(
      support::bathymetry_from([](geo::LonLat p) { return 120.0 + 100.0 * std::sin(20.0 * p.lon_deg); }));

  support::for_each_seed(200, [&](std::mt19937_64& rng) {
    const auto point = [&] {
      return geo::PlanePoint{support::uniform(rng, -29'000.0, 29'000.0),
                             support::uniform(rng, -29'000.0, 29'000.0)};
    };
    const geo::PlanePoint a = point();
    const geo::PlanePoint b = point();
    const geo::PlanePoint middle{0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m)};
    const core::Seconds time{support::uniform(rng, 100.0, 1e5)};
    for (const Drive drive : {Drive::buoyancy, Drive::thruster}) {
      const EnergyUse whole = map.use(a, b, time, drive);
      EnergyUse parts = map.use(a, middle, 0.5 * time, drive);
      parts += map.use(middle, b, 0.5 * time, drive);

      EXPECT_GE(whole.total(), map.least_power(drive) * time);
      EXPECT_NEAR(parts.total().value, whole.total().value, 1e-6 * whole.total().value);
      if (map.is_even_along(a, b)) {
        EXPECT_NEAR(whole.total().value, map.use(a, a, time, drive).total().value,
                    1e-6 * whole.total().value);
      }
    }
  });
}

}  // namespace
}  // namespace floeplan::planning::energy::energy_map_test

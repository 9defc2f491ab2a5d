#include "engine/vehicle/energy_model.hpp"

#include <gtest/gtest.h>

#include "engine/vehicle/thruster.hpp"

namespace floeplan::vehicle::energy_model_test {
namespace {

// 460 cm3 at 200 m: 2.49 J/cm3 and 1027.7 * 9.81 * 200 Pa / 0.82 out, 0.18 J/cm3 in, two inflections of 540 J.
TEST(ToothEnergy, IsTheSumOfItsPartsByHand) {
  const double against_pressure = 1027.7 * 9.81 * 200.0 * 460e-6 / 0.82;

  const core::Joules tooth = tooth_energy({}, {230e-6}, {{5.0}, {200.0}});

  EXPECT_NEAR(against_pressure, 1131.1, 0.1);
  EXPECT_NEAR(tooth.value, 2.49 * 460.0 + against_pressure + 0.18 * 460.0 + 2.0 * 540.0, 1e-6);
}

// The fit itself, in its own units: 2.4888 J/cm3 + 0.012276 J/(cm3 m).
TEST(ToothEnergy, PumpsOutAsTheMeasuredVehicle) {
  for (const double depth_m : {20.0, 200.0, 1000.0}) {
    const EnergyModel pump_only{.intake_j_cm3 = 0.0, .inflection = {0.0}};
    const double measured = 520.0 * (2.4888 + 0.012276 * depth_m);
    EXPECT_NEAR(tooth_energy(pump_only, {260e-6}, {{5.0}, {depth_m}}).value, measured, 2e-3 * measured);
  }
}

TEST(PumpPower, SpreadsTheEnergyOverTheTimeOfATooth) {
  const EnergyModel model;
  const DiveBand band{{5.0}, {105.0}};

  const core::Watts power = pump_power(model, {230e-6}, band, {0.2});

  EXPECT_NEAR(power.value, tooth_energy(model, {230e-6}, band).value / 1000.0, 1e-9);
}

TEST(PumpPower, IsGreaterInShallowWaterWhereTheVehicleTurnsOftener) {
  EXPECT_GT(pump_power({}, {230e-6}, {{5.0}, {20.0}}, {0.19}).value,
            pump_power({}, {230e-6}, {{5.0}, {200.0}}, {0.19}).value);
}

TEST(SteadyPower, CountsSurfacingsOnlyWhereAskedTo) {
  EnergyModel model;
  EXPECT_EQ(steady_power(model).value, 1.16);

  model.surfacing_interval = core::Seconds{3925.0};
  EXPECT_NEAR(steady_power(model).value, 2.16, 1e-12);
}

TEST(Battery, KeepsItsReserve) {
  const EnergyModel model{.battery = {1000.0}, .battery_start_share = 0.8, .battery_reserve_share = 0.1};
  EXPECT_NEAR(model.usable().value, 700.0, 1e-9);
}

// 0.5213 * 1 W^0.3467 = 0.5213 m/s; the battery gives 4.3378 + 2.0227 W for it.
TEST(ThrusterPower, FollowsItsFit) {
  EXPECT_NEAR(thruster_power({0.5213}).value, 6.3605, 1e-9);
  EXPECT_LT(thruster_power({0.4}), thruster_power({0.5}));
}

}  // namespace
}  // namespace floeplan::vehicle::energy_model_test

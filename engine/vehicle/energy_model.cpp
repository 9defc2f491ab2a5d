#include "engine/vehicle/energy_model.hpp"

#include "engine/vehicle/sea_water.hpp"

namespace floeplan::vehicle {
namespace {

constexpr double cm3_per_m3 = 1e6;

}  // namespace

core::Joules tooth_energy(const EnergyModel& model, core::CubicMetres buoyancy, const DiveBand& band) {
  const double moved_m3 = 2.0 * buoyancy.value;
  const double pressure_pa = sea_water_density_kg_m3 * gravity_m_s2 * band.bottom.value;
  const double against_pressure_j = pressure_pa * moved_m3 / model.pump_efficiency;
  const double losses_j = (model.pump_loss_j_cm3 + model.intake_j_cm3) * cm3_per_m3 * moved_m3;
  return {against_pressure_j + losses_j + 2.0 * model.inflection.value};
}

core::Watts pump_power(const EnergyModel& model, core::CubicMetres buoyancy, const DiveBand& band,
                       core::MetresPerSecond vertical) {
  const core::Seconds tooth = 2.0 * band.thickness() / vertical;
  return {tooth_energy(model, buoyancy, band).value / tooth.count()};
}

core::Watts steady_power(const EnergyModel& model) {
  if (!model.surfacing_interval) return model.hotel;
  return model.hotel + core::Watts{model.surfacing.value / model.surfacing_interval->count()};
}

}  // namespace floeplan::vehicle

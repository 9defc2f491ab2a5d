#include "engine/simulation/vehicle/energy_meter.hpp"

#include "engine/vehicle/sea_water.hpp"

namespace floeplan::simulation {
namespace {

constexpr double cm3_per_m3 = 1e6;

}  // namespace

void EnergyMeter::run(core::Seconds step, bool thruster) {
  drawn_j_ += profile_.energy.hotel.value * step.count();
  if (thruster && profile_.thruster) drawn_j_ += profile_.thruster->power.value * step.count();
}

void EnergyMeter::pump(double moved_m3, double depth_m) {
  const vehicle::EnergyModel& model = profile_.energy;
  if (moved_m3 <= 0.0) {
    drawn_j_ += model.intake_j_cm3 * cm3_per_m3 * -moved_m3;
    return;
  }
  const double pressure_pa = vehicle::sea_water_density_kg_m3 * vehicle::gravity_m_s2 * depth_m;
  drawn_j_ += moved_m3 * (pressure_pa / model.pump_efficiency + model.pump_loss_j_cm3 * cm3_per_m3);
}

}  // namespace floeplan::simulation

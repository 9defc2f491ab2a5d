#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/vehicle/dive_band.hpp"

namespace floeplan::vehicle {

/// The energy that a glider draws from its battery.
/// Source  of the defaults: P. Welch, Oregon State University, GliderSimulator (github.com/mousebrains/
///         GliderSimulator, energy.json and extractEnergy.m), fits to the coulomb counters of ten Slocum G3
///         deployments of 2018 and 2019. Hotel: mean of 1.31 W diving and 1.00 W climbing. Pumping out one
///         cubic centimetre: 2.4888 J and 0.012276 J for each metre of depth, which is the work against the
///         pressure at an efficiency of 0.82. Letting in: 0.179 J. Inflection: 540 J to shift the pitch
///         battery (its author calls the reading unsteady). Surfacing: 389 J and 5.55 W for a call of 637 s.
struct EnergyModel {
  core::Watts hotel{1.16};                            // power of all that is on under water, sensors included
  double pump_efficiency{0.82};                       // work against the pressure per energy drawn for it
  double pump_loss_j_cm3{2.49};                       // added per cm3 pumped out, at any depth
  double intake_j_cm3{0.18};                          // per cm3 let in, to make the vehicle heavy at the top
  core::Joules inflection{540.0};                     // of each turn, at the top and at the bottom
  core::Joules surfacing{3925.0};                     // air pump, position and telemetry of one surfacing
  std::optional<core::Seconds> surfacing_interval{};  // empty: surfacings are not counted
  core::Joules battery{12'171'600.0};                 // full: 3381 Wh, the lithium-ion pack of the same G3
  double battery_start_share{1.0};                    // share of it at the departure
  double battery_reserve_share{0.1};  // of it, kept: at this charge the vehicle aborts its mission
                                      // (remaining_charge_min of the vendor's behavior abend)

  /// The energy that a mission may draw.
  [[nodiscard]] core::Joules usable() const {
    return (battery_start_share - battery_reserve_share) * battery;
  }
  friend bool operator==(const EnergyModel&, const EnergyModel&) = default;
};

/// Energy of one full saw-tooth: a dive and a climb with two inflections. The buoyancy changes from
/// `buoyancy` below neutral to `buoyancy` above. So the pump moves twice this volume out at the bottom and in
/// at the top.
[[nodiscard]] core::Joules tooth_energy(const EnergyModel& model, core::CubicMetres buoyancy,
                                        const DiveBand& band);

/// Mean power of pump and inflections, for dives in the band with this vertical speed.
[[nodiscard]] core::Watts pump_power(const EnergyModel& model, core::CubicMetres buoyancy,
                                     const DiveBand& band, core::MetresPerSecond vertical);

/// Power of the hotel load and, if they are counted, of the surfacings.
[[nodiscard]] core::Watts steady_power(const EnergyModel& model);

}  // namespace floeplan::vehicle

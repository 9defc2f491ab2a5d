#pragma once

#include "engine/core/units.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::simulation {

/// Adds up the energy drawn from the battery during a flight, by vehicle::EnergyModel.
class EnergyMeter {
 public:
  explicit EnergyMeter(const vehicle::GliderProfile& profile) : profile_{profile} {}

  void run(core::Seconds step, bool thruster);
  /// The pump moved this volume at this depth: positive out against the pressure, negative in.
  void pump(double moved_m3, double depth_m);
  void inflect() { drawn_j_ += profile_.energy.inflection.value; }
  void surface() { drawn_j_ += profile_.energy.surfacing.value; }

  [[nodiscard]] core::Joules drawn() const { return {drawn_j_}; }
  [[nodiscard]] bool is_empty() const { return drawn_j_ >= profile_.energy.usable().value; }

 private:
  vehicle::GliderProfile profile_;
  double drawn_j_{};
};

}  // namespace floeplan::simulation

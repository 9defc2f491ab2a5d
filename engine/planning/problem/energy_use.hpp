#pragma once

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// What a way draws from the battery.
struct EnergyUse {
  core::Joules hotel{};  // all that is always on; surfacings, where they are counted
  core::Joules pump{};   // buoyancy pump and pitch battery at the inflections
  core::Joules thruster{};
  double inflections{};  // expected: where the saw-tooth's phase lies on the way is nobody's choice

  [[nodiscard]] core::Joules total() const { return hotel + pump + thruster; }
  EnergyUse& operator+=(const EnergyUse& more) {
    hotel = hotel + more.hotel;
    pump = pump + more.pump;
    thruster = thruster + more.thruster;
    inflections += more.inflections;
    return *this;
  }
};

}  // namespace floeplan::planning

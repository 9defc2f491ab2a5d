#pragma once

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// The energy that a route draws from the battery.
struct EnergyUse {
  core::Joules hotel{};  // all that is always switched on, and the surfacings if they are counted
  core::Joules pump{};   // buoyancy pump and pitch battery at the inflections
  core::Joules thruster{};
  double inflections{};  // expected number: where on the saw-tooth the vehicle begins is unknown

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

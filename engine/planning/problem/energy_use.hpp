#pragma once

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// The energy that a route draws from the battery.
struct EnergyUse {
  core::Joules hotel{};  // what is always on, and the surfacings where they are counted
  core::Joules pump{};   // buoyancy pump and pitch battery at the inflections
  core::Joules thruster{};
  double inflections{};  // expected number, because nobody chooses the phase of the saw-tooth on the route

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

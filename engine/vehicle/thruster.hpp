#pragma once

#include "engine/core/units.hpp"

namespace floeplan::vehicle {

/// A propeller that moves the vehicle faster along the same path: same angle, same inflections.
struct Thruster {
  core::MetresPerSecond speed{0.5};  // horizontal, through the water
  core::Watts power{};               // drawn from the battery in addition to all else

  friend bool operator==(const Thruster&, const Thruster&) = default;
};

/// Power that the thruster of a Slocum draws to keep a speed through the water.
/// Source  speed = 0.5213 * P^0.3467 by P at the propeller in W: Z. Duguid, Woods Hole Oceanographic
///         Institution, battery-sys (github.com/zduguid/battery-sys, glider_range.py), fit of a hybrid Slocum;
///         drawn from the battery 4.34 + 2.023 * P: GliderSimulator as in EnergyModel
[[nodiscard]] core::Watts thruster_power(core::MetresPerSecond speed);

}  // namespace floeplan::vehicle

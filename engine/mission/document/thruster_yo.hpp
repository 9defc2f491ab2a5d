#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::mission {

/// Value of `use_thruster` for a constant input power in W, and the range of that power.
/// Source   comments of the vendor's argument files as fisheries scientists fly them
///          (SWFSC/standard-glider-files, drift_20.ma and yo20_processor.ma): "4 Command input power", "watt,
///          desired input power, between [1, 9] Watts"
inline constexpr int thruster_by_power = 4;
inline constexpr core::Watts least_thruster_power{1.0};
inline constexpr core::Watts most_thruster_power{9.0};

/// The input power with which one yo flies the whole plan on the thruster. It is the power of the vehicle's
/// profile, which keeps the planned speed. Empty if some leg is flown without the thruster, if the vehicle
/// has no thruster of this speed, or if the firmware does not accept this power.
/// Threads  may be called from several threads at once
[[nodiscard]] std::optional<core::Watts> thruster_of_yo(const planning::Plan& plan,
                                                        const vehicle::GliderProfile& vehicle);

}  // namespace floeplan::mission

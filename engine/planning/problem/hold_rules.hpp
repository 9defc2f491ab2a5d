#pragma once

#include "engine/core/units.hpp"

namespace floeplan::planning {

/// Longest hold that a request may allow. Forecasts of more than about ten days do not tell when water closes
/// and reopens. A judgement.
inline constexpr core::Seconds longest_hold_allowed{10.0 * 86'400.0};

/// How the vehicle may hold station: stay near a place by making way against the current.
struct HoldRules {
  /// Longest hold at one place, until a closure ends: icebergs that drift, zones with times, or currents that
  /// are too strong. Zero: the vehicle never holds.
  core::Seconds longest{longest_hold_allowed};
  /// Radius of the circle within which the vehicle holds. A judgement: a glider that is sent back to one place dive
  /// after dive comes up some hundreds of metres from it.
  core::Metres radius{500.0};
};

}  // namespace floeplan::planning

#pragma once

#include "engine/core/units.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning {

/// Growth of a vehicle's dead-reckoning error in the time under way: a share of the distance through water,
/// and the uncertainty of the currents times the time.
[[nodiscard]] inline core::Metres grown_error(const UnderIceRules& rules, core::MetresPerSecond through_water,
                                              core::Seconds time) {
  const core::Metres way{through_water.value * time.count()};
  return rules.dead_reckoning_share * way + core::Metres{rules.current_uncertainty.value * time.count()};
}

}  // namespace floeplan::planning

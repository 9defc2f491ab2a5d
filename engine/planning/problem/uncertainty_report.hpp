#pragma once

#include <cstddef>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/planning/problem/arrival_spread.hpp"
#include "engine/planning/problem/member_spread.hpp"
#include "engine/planning/problem/uncertainty_rules.hpp"

namespace floeplan::planning {

/// How a plan fares where the currents are not certain.
struct UncertaintyReport {
  ArrivalSpread spread;  // of the plan's own route, over all members
  RobustObjective objective{RobustObjective::none};
  double quantile{0.9};
  std::size_t candidates{1};  // routes that were compared
  std::optional<core::UtcTime> arrive_before;
  std::optional<double> chance;         // to be there by then
  std::optional<MemberSpread> costs{};  // of the route by the request's objective; not kept with stored plans
};

}  // namespace floeplan::planning

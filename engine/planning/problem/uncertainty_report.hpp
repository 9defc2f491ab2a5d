#pragma once

#include <cstddef>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/planning/problem/arrival_spread.hpp"
#include "engine/planning/problem/member_spread.hpp"
#include "engine/planning/problem/uncertainty_rules.hpp"

namespace floeplan::planning {

/// The spread of a plan's arrival when the currents are uncertain.
struct UncertaintyReport {
  ArrivalSpread spread;  // travel times of the plan's route in all members
  RobustObjective objective{RobustObjective::none};
  double quantile{0.9};
  std::size_t candidates{1};  // number of routes compared
  std::optional<core::UtcTime> arrive_before;
  std::optional<double> chance;         // of arriving by `arrive_before`
  std::optional<MemberSpread> costs{};  // costs of the route by the request's objective; not stored
};

}  // namespace floeplan::planning

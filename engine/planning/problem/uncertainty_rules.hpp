#pragma once

#include <cstdint>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/ocean/currents/current_error.hpp"

namespace floeplan::planning {

/// The statistic that a route minimises when the currents are uncertain.
enum class RobustObjective {
  none,     // plan in the first member alone; the plan states its spread over all members
  mean,     // the least mean travel time over the members
  quantile  // the least time within which a share of the members arrives
};

/// How a plan treats uncertain currents: the members of an ensemble (several stored currents), or errors
/// of a model that are added to the one forecast.
struct UncertaintyRules {
  int drawn_members{0};  // members to draw from the error model; 0: none
  ocean::CurrentErrorModel error{};
  std::uint64_t seed{1};
  RobustObjective objective{RobustObjective::none};
  double quantile{0.9};
  std::optional<core::UtcTime> arrive_before;  // asks for the chance of arriving by this time

  /// Empty when valid, otherwise all of them, with the fields of the inputs' member "uncertainty".
  [[nodiscard]] core::Violations violations() const;
};

}  // namespace floeplan::planning

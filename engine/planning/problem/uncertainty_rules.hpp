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
  mean,     // the least mean cost over the members
  quantile  // the least cost that a share of the members does not exceed
};

/// Rules for uncertain currents: either the members of an ensemble (several stored currents), or members
/// drawn by adding random errors of a model to the one forecast.
struct UncertaintyRules {
  int drawn_members{0};  // number of members drawn from the error model
  ocean::CurrentErrorModel error{};
  std::uint64_t seed{1};
  RobustObjective objective{RobustObjective::none};
  double quantile{0.9};
  std::optional<core::UtcTime> arrive_before;  // asks for the probability of arriving by this time

  /// Empty if valid, otherwise all violations; their fields begin with "uncertainty".
  [[nodiscard]] core::Violations violations() const;
};

}  // namespace floeplan::planning

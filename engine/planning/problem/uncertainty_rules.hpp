#pragma once

#include <cstdint>
#include <optional>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"
#include "engine/ocean/currents/current_error.hpp"

namespace floeplan::planning {

/// What to make the best of when the currents are not known for certain.
enum class RobustObjective {
  none,     // plan in the first currents, then say how the plan fares in all
  mean,     // the least mean travel time over the members
  quantile  // the least time that a share of the members keeps
};

/// How a plan treats currents that are not certain: the members of an ensemble (several stored currents), or errors
/// of a model that are added to the one forecast.
struct UncertaintyRules {
  int drawn_members{0};  // of the error model; 0: none
  ocean::CurrentErrorModel error{};
  std::uint64_t seed{1};
  RobustObjective objective{RobustObjective::none};
  double quantile{0.9};
  std::optional<core::UtcTime> arrive_before;  // the chance to be there by then is asked for

  /// Empty when valid, otherwise all of them, with the fields of the inputs' member "uncertainty".
  [[nodiscard]] core::Violations violations() const;
};

}  // namespace floeplan::planning

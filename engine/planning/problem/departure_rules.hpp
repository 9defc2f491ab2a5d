#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::planning {

/// When to leave, where a request does not fix it: a window of departures to compare, or a wanted arrival.
struct DepartureRules {
  static constexpr int most_departures = 1000;  // six weeks of hours

  std::optional<core::UtcTime>
      until{};                 // the last departure of the window; the first is the request's `depart`
  core::Seconds step{3600.0};  // between two departures of the window
  std::optional<core::UtcTime>
      arrive_by{};  // asks for the latest departure, not before `depart`, that arrives by this time

  /// The departures of the window, `depart` first. Without a window, `depart` alone.
  /// Precondition  the rules hold
  [[nodiscard]] std::vector<core::UtcTime> departures(core::UtcTime depart) const;
  [[nodiscard]] core::Violations violations(core::UtcTime depart) const;
};

}  // namespace floeplan::planning

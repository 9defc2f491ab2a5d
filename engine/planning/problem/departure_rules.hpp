#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::planning {

/// When to depart if a request does not fix the time: a window of departures to compare, or a wanted arrival.
struct DepartureRules {
  static constexpr int most_departures = 1000;  // six weeks at one-hour steps

  std::optional<core::UtcTime>
      until{};                 // the last departure of the window; the first is the request's `depart`
  core::Seconds step{3600.0};  // between two departures of the window
  std::optional<core::UtcTime>
      arrive_by{};  // wanted arrival: asks for the latest departure, from `depart` on, that arrives by then

  /// The departures of the window, beginning with `depart`. Without a window only `depart`.
  /// Precondition  the rules are valid
  [[nodiscard]] std::vector<core::UtcTime> departures(core::UtcTime depart) const;
  [[nodiscard]] core::Violations violations(core::UtcTime depart) const;
};

}  // namespace floeplan::planning

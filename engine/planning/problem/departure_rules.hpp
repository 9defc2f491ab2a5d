#pragma once

#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/core/violation.hpp"

namespace floeplan::planning {

/// When to leave, where a request does not fix it: a window of departures to compare, or a wanted arrival.
struct DepartureRules {
  static constexpr int most_departures = 1000;  // six weeks of hours

  std::optional<core::UtcTime> until{};  // departures from the request's `depart` to this one are compared
  core::Seconds step{3600.0};            // from one departure to the next
  std::optional<core::UtcTime>
      arrive_by{};  // the latest departure that arrives by then, none before `depart`

  /// The departures of the window, `depart` first; it alone when there is no window.
  /// Precondition  the rules hold
  [[nodiscard]] std::vector<core::UtcTime> departures(core::UtcTime depart) const;
  [[nodiscard]] core::Violations violations(core::UtcTime depart) const;
};

}  // namespace floeplan::planning

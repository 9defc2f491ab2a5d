#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::planning {

/// What leaving at one moment leads to.
struct DepartureOutcome {
  core::UtcTime departure;
  std::optional<core::Seconds> travel_time{};  // of one grid's way, before refinement; empty: there is none
  std::optional<core::Joules> energy{};        // drawn on that way; empty likewise
  std::optional<Infeasible> closed{};          // why there is none
  /// What a robust objective counts of the costs of the best ways in all members, which one way for all of them cannot
  /// undercut; of a departure that was planned, of its plan's way. Infinite where too few have one, empty without such
  /// an objective.
  std::optional<double> robust_cost{};
  std::size_t members_closed{};  // in which there is no way, with such an objective

  [[nodiscard]] core::UtcTime arrival() const { return departure + travel_time.value(); }
};

/// A window's outcomes and the plan for the best of its departures: the plan for this departure alone. Its travel
/// time may be less than the curve's, because only this way is refined. A departure of which no plan comes although
/// there is a way, for want of battery, say, counts as closed. With a robust objective departures are planned until
/// none that is left may be better, six at most: then the best of those, with a warning.
struct WindowPlan {
  std::vector<DepartureOutcome> departures;
  Result<Plan> plan;  // the reason of the best departure, or of the first one when every one is closed
};

}  // namespace floeplan::planning

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/planning/problem/infeasible.hpp"
#include "engine/planning/problem/plan.hpp"

namespace floeplan::planning {

/// The outcome of one departure of a window.
struct DepartureOutcome {
  core::UtcTime departure;
  std::optional<core::Seconds>
      travel_time{};  // of the best route on the grid, before refinement; empty: there is none
  std::optional<core::Joules> energy{};  // drawn on that route; empty where there is none
  std::optional<Infeasible> closed{};    // why there is no route
  /// The robust objective over the costs of the best route in each member. One route for all members costs at least as
  /// much. For a departure that was planned it is the objective of the plan's route. Infinite where too few members
  /// have a route; empty without a robust objective.
  std::optional<double> robust_cost{};
  std::size_t members_closed{};  // members without a route, with a robust objective

  [[nodiscard]] core::UtcTime arrival() const { return departure + travel_time.value(); }
};

/// The outcomes of a window and the plan for the best departure. The plan equals a plan for this departure alone.
/// Only its route is refined, so its travel time may be shorter than in the outcome. A departure with a route but
/// without a plan counts as closed, for example if the battery is too small. With a robust objective, departures
/// are planned until no other can be better, but at most six. The plan is then the best of those six, and a message
/// says so.
struct WindowPlan {
  std::vector<DepartureOutcome> departures;
  Result<Plan> plan;  // without a plan: why the best departure is closed, or the first one where all are
};

}  // namespace floeplan::planning

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning {

/// The kind of most of a large obstacle.
enum class ObstacleKind : std::uint8_t { land, shallow_water, icebergs, closed_area, no_data };

/// A route that passes a large obstacle on the other side than the best plan does.
struct Alternative {
  Plan plan;
  PlanRequest request;  // its own: the given plan's, or that with no-go areas across the given plan's route
  messages::Message reason;  // names the obstacle and the extra travel time
};

/// The alternatives to a plan, the best first; none costs less than the best plan.
struct Alternatives {
  // a plan of the same request that costs less than the given plan, which is then one of the alternatives: both searches
  // are limited to the paths of their grid, and the refinement to a local optimum. Empty: the given plan is the best
  std::optional<Plan> better;
  std::vector<Alternative> found;
  std::optional<messages::Message> fewer;  // reason if fewer were found than requested
};

}  // namespace floeplan::planning

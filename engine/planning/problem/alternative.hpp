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

/// A route that passes a large obstacle on the other side than a given plan does.
struct Alternative {
  Plan plan;
  PlanRequest request;       // the given plan's request, with no-go areas across that plan's route
  messages::Message reason;  // names the obstacle and the extra travel time
};

/// The alternatives to a plan, the best first.
struct Alternatives {
  std::vector<Alternative> found;
  std::optional<messages::Message> fewer;  // reason if fewer were found than requested
};

}  // namespace floeplan::planning

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/messages/message.hpp"
#include "engine/planning/problem/plan.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning {

/// What a large obstacle is for the most part.
enum class ObstacleKind : std::uint8_t { land, shallow_water, icebergs, closed_area, no_data };

/// A route that leaves a large obstacle on its other side than a given plan does.
struct Alternative {
  Plan plan;
  PlanRequest request;       // that it answers: the given plan's, with no-go areas across that plan's route
  messages::Message reason;  // round what it leads, and what it takes
};

/// The alternatives to a plan, the best first.
struct Alternatives {
  std::vector<Alternative> found;
  std::optional<messages::Message> fewer;  // why there are fewer than asked for
};

}  // namespace floeplan::planning

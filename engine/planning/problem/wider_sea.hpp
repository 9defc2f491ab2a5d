#pragma once

#include <functional>
#include <optional>

#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning {

/// What is known of the `planning_area` of a request with more room than usual; empty: nothing that could be used.
using WiderSea = std::function<std::optional<ocean::Environment>(const PlanRequest&)>;

}  // namespace floeplan::planning

#pragma once

#include <functional>
#include <optional>

#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning {

/// Loads the data of the `planning_area` of a request with more room than usual. Returns empty if there are
/// none. The function itself may be empty.
using WiderSea = std::function<std::optional<ocean::Environment>(const PlanRequest&)>;

}  // namespace floeplan::planning

#pragma once

#include <functional>
#include <optional>

#include "engine/ocean/environment.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning {

/// The data in the `planning_area` of a request with more room than usual. Empty: no data can be used there.
using WiderSea = std::function<std::optional<ocean::Environment>(const PlanRequest&)>;

}  // namespace floeplan::planning

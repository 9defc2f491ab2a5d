#pragma once

#include <stop_token>

#include "engine/ocean/environment.hpp"
#include "engine/planning/infeasible.hpp"
#include "engine/planning/layout.hpp"
#include "engine/planning/plan_request.hpp"
#include "engine/planning/sea.hpp"

namespace floeplan::planning {

/// A request laid out in its plane: everything a search needs, made once and used for every departure and every
/// try. Times are counted from the request's departure.
struct Chart {
  Layout layout;
  Sea sea;
};

/// Errors   Reason::too_large for a grid beyond bounded memory (a direct way needs none); why a stop cannot be
///          used; Reason::cancelled once `stop` is requested
/// `environment` and `request` are borrowed and outlive the chart.
[[nodiscard]] Result<Chart> draw_chart(const ocean::Environment& environment, const PlanRequest& request,
                                       GridReach reach, const std::stop_token& stop);

}  // namespace floeplan::planning

#pragma once

#include "engine/planning/planner/task.hpp"

namespace floeplan::planning::planner {

/// Plans the request's vias in the order that reaches the goal earliest. Where there is no plan in that order, or one
/// that is later than the order promised, in a few other orders, too, and in the order given: travel times on coarse
/// grids do not tell all that closes and opens on the way.
/// Law      where there is a plan in the order given there is one, no later than that by more than a few percent where
///          the time is what is minded
/// `plan_in_order`  plans a request whose vias are in the order of their visits
/// Errors   why there is no plan in the order given
/// Stops    with Reason::cancelled
[[nodiscard]] Result<Plan> plan_survey(const Task& task, const Planning& plan_in_order);

}  // namespace floeplan::planning::planner

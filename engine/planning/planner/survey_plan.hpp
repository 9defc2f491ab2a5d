#pragma once

#include "engine/planning/planner/task.hpp"

namespace floeplan::planning::planner {

/// Plans with the via points in the order that reaches the goal earliest. Where there is no plan in that order, or a later one
/// than estimated, it also plans in a few other orders and in the given one: travel times on coarse grids do not show
/// everything that closes and reopens on the way.
/// Law      If there is a plan in the given order, there is a result. If the objective is time, the result is later than that
///          plan by a few per cent at most
/// `plan_in_order`  plans a request whose vias are in the order of their visits
/// Errors   why there is no plan in the order given
/// Stops    with Reason::cancelled
[[nodiscard]] Result<Plan> plan_survey(const Task& task, const Planning& plan_in_order);

}  // namespace floeplan::planning::planner

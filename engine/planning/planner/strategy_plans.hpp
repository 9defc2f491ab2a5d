#pragma once

#include "engine/planning/planner/task.hpp"

namespace floeplan::planning::planner {

/// Plans the route with the earliest arrival in one sea, past the via points in the given order. It searches a smaller area,
/// and a larger one where that may give a better plan. Only the returned plan is compared with the best possible way.
/// Precondition  the request is valid
/// Errors and Stops  as plan_route
/// `rest`   is not used: there is no simpler plan
[[nodiscard]] Result<Plan> plan_fastest(const Task& task, const Planning& rest);

/// Plans with the via points in the order that reaches the goal earliest. Where there is no plan in that order, or a later one
/// than estimated, it also plans in a few other orders and in the given one: travel times on coarse grids do not show
/// everything that closes and reopens on the way.
/// Law      If there is a plan in the given order, there is a result. If the objective is time, the result is later than that
///          plan by a few per cent at most
/// `plan_in_order`  plans a request whose vias are in the order of their visits
/// Errors   why there is no plan in the order given
/// Stops    with Reason::cancelled
[[nodiscard]] Result<Plan> plan_survey(const Task& task, const Planning& plan_in_order);

/// Plans with the request's weight on expected encounters with icebergs. The result is the plan without the weight, unless
/// another plan has fewer expected encounters and costs less with the weight. So the weight never increases the encounters.
/// `plan_unweighted` plans a request without the weight
/// Errors   as plan_route
/// Stops    as plan_route
[[nodiscard]] Result<Plan> plan_with_fewer_encounters(const Task& task, const Planning& plan_unweighted);

}  // namespace floeplan::planning::planner

#pragma once

#include "engine/planning/planner/task.hpp"

namespace floeplan::planning::planner {

/// Plans the route with the earliest arrival in one environment, past the via points in the given order.
/// Searches a smaller area, and a larger one if that may give a better plan. If the request asks for the
/// optimality gap, it is computed for the returned plan only.
/// Precondition  the request is valid
/// Errors and Stops  as plan_route
/// `rest`   unused: no simpler plan exists
[[nodiscard]] Result<Plan> plan_fastest(const Task& task, const Planning& rest);

/// Plans with the via points in the order that reaches the goal earliest. If there is no plan in that order,
/// or it is later than estimated, also plans in a few other orders and in the given one: travel times on
/// coarse grids do not show all closures on the way.
/// Law      If there is a plan in the given order, there is a result. If the objective is time, the result is
///          later than that plan by at most a few per cent
/// `plan_in_order`  plans a request whose via points are in the order of their visits
/// Errors   why there is no plan in the given order
/// Stops    with Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> plan_survey(const Task& task, const Planning& plan_in_order);

/// Plans with the request's weight on expected encounters with icebergs. The result is the plan without the
/// weight, unless another plan has fewer expected encounters and costs less with the weight. So the weight
/// never adds encounters.
/// `plan_unweighted` plans a request without the weight
/// Errors   as plan_route
/// Stops    as plan_route
[[nodiscard]] Result<Plan> plan_with_fewer_encounters(const Task& task, const Planning& plan_unweighted);

}  // namespace floeplan::planning::planner

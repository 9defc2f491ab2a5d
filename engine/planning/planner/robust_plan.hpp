#pragma once

#include "engine/planning/cost/sea_members.hpp"
#include "engine/planning/planner/task.hpp"
#include "engine/planning/problem/member_spread.hpp"

namespace floeplan::planning::planner {

/// The objective over the costs in the members; less is better. Infinite where it depends on a member without a cost.
[[nodiscard]] double what_counts(const MemberSpread& costs, const UncertaintyRules& rules);

/// Whether one result is better: it is open in more members; if equal, its objective is less; if too few members are open for
/// the objective, its mean cost in the open ones is less.
[[nodiscard]] bool is_better(const MemberSpread& a, const MemberSpread& b, const UncertaintyRules& rules);

/// The arrival of a plan by its objective: the mean over the members that arrive, or the time by which the requested share of
/// the members arrives. Without a robust objective it is the arrival in the first currents. Infinitely late where too few
/// members arrive.
[[nodiscard]] core::UtcTime arrival_that_counts(const Plan& plan, const UncertaintyRules& rules);

/// A plan with its spread over all members. Without a robust objective it is the plan in the first currents. With one there are
/// more candidates: the routes planned for each member, and for the mean of an ensemble on equal grids. Each candidate is
/// timed in every member with the drives that it has in the first currents. The candidate that is open in the most members and
/// has the best objective over them is published, with its times in the first currents.
/// Limits   in every member icebergs drift with its own currents. Only the best routes of the members and of their mean are
///          compared; another compromise is not found
/// `plan_in_one_sea`  plans the task in one member as if there were no other
/// Errors   as `plan_in_one_sea`; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> plan_uncertain(const Task& task, const Planning& plan_in_one_sea);

}  // namespace floeplan::planning::planner

#pragma once

#include "engine/planning/cost/sea_members.hpp"
#include "engine/planning/planner/task.hpp"
#include "engine/planning/problem/member_spread.hpp"

namespace floeplan::planning::planner {

/// The value of the robust objective over the costs in the members; less is better. Infinite if too many
/// members are closed.
[[nodiscard]] double what_counts(const MemberSpread& costs, const UncertaintyRules& rules);

/// Whether `a` is better: it is open in more members; if equal, its objective is less; if too few members are
/// open for the objective, its mean cost in the open ones is less.
[[nodiscard]] bool is_better(const MemberSpread& a, const MemberSpread& b, const UncertaintyRules& rules);

/// The arrival of a plan by the robust objective: the mean over the members that arrive, or the time by which
/// the requested share of the members arrives. Without a robust objective it is the arrival in the
/// currents of the first member. If too few members arrive, it is infinitely late.
[[nodiscard]] core::UtcTime arrival_that_counts(const Plan& plan, const UncertaintyRules& rules);

/// A plan with its spread over all members. Without a robust objective it is the plan in the currents of the
/// first member. With one there are more candidates: the routes planned for each member, and for the mean of
/// an ensemble on equal grids. Each candidate is timed in every member with the propulsion that it has in the
/// first member. The candidate that is open in the most members and has the best objective over them is
/// published, with its times in the currents of the first member.
/// Limits   In every member icebergs drift with its own currents. Candidates are only the best routes of
///          single members and of their mean; a better compromise is not found
/// `plan_in_one_sea`  plans the task in one member as if there were no other
/// Errors   as `plan_in_one_sea`; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> plan_uncertain(const Task& task, const Planning& plan_in_one_sea);

}  // namespace floeplan::planning::planner

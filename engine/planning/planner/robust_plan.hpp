#pragma once

#include "engine/planning/cost/sea_members.hpp"
#include "engine/planning/planner/task.hpp"
#include "engine/planning/problem/member_spread.hpp"

namespace floeplan::planning::planner {

/// What the objective counts of costs in the members, less is better; infinite where it would take a member without
/// one.
[[nodiscard]] double what_counts(const MemberSpread& costs, const UncertaintyRules& rules);

/// The one that more members let through; of equals the one whose costs count less, and where too few members come
/// through for that, the one that costs less in the mean of those that do.
[[nodiscard]] bool is_better(const MemberSpread& a, const MemberSpread& b, const UncertaintyRules& rules);

/// When a plan arrives by what is made the best of: in the mean of the members that arrive, or in the share of them
/// that is to be in time; without such an objective in the first currents. Infinitely late where too few members
/// arrive.
[[nodiscard]] core::UtcTime arrival_that_counts(const Plan& plan, const UncertaintyRules& rules);

/// A plan with its spread over all members. Without an objective over them it is the plan of the first currents. With
/// one, the routes planned for each member, and for the mean of an ensemble's on equal grids, are candidates beside it:
/// each is driven in every member as it would be in the first currents, and the one whose costs by the request's
/// objective are best over the members is published, timed in the first currents. A candidate that fewer members let
/// through comes after one that more let through.
/// Limits   icebergs drift in every member as the member's own currents carry them; candidates are the best
///          routes of the members and of their mean, so that another compromise is not found
/// `plan_in_one_sea`  plans the task in one member as if there were no other
/// Errors   as `plan_in_one_sea`; Reason::cancelled once `stop` is requested
[[nodiscard]] Result<Plan> plan_uncertain(const Task& task, const Planning& plan_in_one_sea);

}  // namespace floeplan::planning::planner

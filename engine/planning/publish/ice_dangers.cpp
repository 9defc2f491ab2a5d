#include "engine/planning/publish/ice_dangers.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "engine/core/message_rank.hpp"
#include "engine/geo/geodesic.hpp"

namespace floeplan::planning::publish {
namespace {

/// What is not known, and was open when last known, is not.
bool lies_under_ice(const SurfacingState& state) {
  return !state.may_surface && state.least_upper_turn.value > 0.0;
}

void warn_of_start_and_goal(Plan& plan) {
  const SurfacingState& start = plan.surfacing->waypoints.front();
  const SurfacingState& goal = plan.surfacing->waypoints.back();
  if (lies_under_ice(start)) {
    plan.warnings.push_back(core::as_danger(
        "the start lies under ice: the vehicle may not surface at the departure, and the plan can "
        "begin only where it is brought below the ice. Move the start to open water; the simulator "
        "flies no plan that begins under ice"));
  } else if (!start.may_surface) {
    plan.warnings.emplace_back(
        "the vehicle may not surface at the departure, as far as is known: nothing is known of the ice "
        "there. Make "
        "sure that the water is open");
  }
  if (lies_under_ice(goal)) {
    plan.warnings.push_back(core::as_danger(
        "the goal lies under ice: the vehicle may not surface at the goal. Move the goal to open water"));
  } else if (!goal.may_surface) {
    plan.warnings.emplace_back(
        "the vehicle may not surface at the goal, as far as is known: nothing is known of the ice there");
  }
}

/// Via points are waypoints of the route.
void warn_of_vias_under_ice(Plan& plan, const PlanRequest& request) {
  constexpr core::Metres same_place{1.0};
  constexpr std::size_t most_named = 10;
  std::string under;
  std::size_t count = 0;
  for (std::size_t i = 0; i < request.via.size(); ++i) {
    const auto is_under = [&](std::size_t waypoint) {
      return lies_under_ice(plan.surfacing->waypoints[waypoint]) &&
             geo::geodesic_between(plan.waypoints[waypoint].place, request.via[i]).length < same_place;
    };
    std::size_t waypoint = 0;
    while (waypoint < plan.waypoints.size() && !is_under(waypoint)) ++waypoint;
    if (waypoint == plan.waypoints.size()) continue;
    if (count++ < most_named) under += (under.empty() ? "" : ", ") + std::to_string(i + 1);
  }
  if (count == 0) return;
  plan.warnings.push_back(
      core::as_danger(std::to_string(count) + " of " + std::to_string(request.via.size()) +
                      (request.via.size() == 1 ? " via point lies" : " via points lie") +
                      " under ice (number " + under + (count > most_named ? " and more" : "") +
                      "): the vehicle may not surface there. Move them to open water, or make sure that it "
                      "need not surface"));
}

/// The longest that the missions in use let a glider be out of contact: no surfacing for want of communication is
/// ordered later than this.
/// Source   when_secs of the surface behaviors for start_when 12 in the missions published for deep Slocums, 5 to 12 h
constexpr core::Seconds longest_out_of_contact{43200.0};

/// A pilot who bounds that time has said how long it may be.
void warn_of_long_below_ice(Plan& plan, const PlanRequest& request) {
  const core::Seconds longest = plan.surfacing->longest_without;
  const bool below_ice = std::ranges::any_of(plan.surfacing->waypoints, [](const SurfacingState& state) {
    return state.leg_upper_turn.value_or(core::Metres{0.0}).value > 0.0;
  });
  if (request.under_ice.max_time_without_surfacing || !below_ice || longest <= longest_out_of_contact) return;
  char text[320];
  std::snprintf(
      text, sizeof text,
      "for %.1f h the vehicle finds no place to surface below the ice: no fix, no contact, and no way up in "
      "an emergency. Bound that time (--max-time-without-surfacing), or keep off the ice",
      longest.count() / 3600.0);
  plan.warnings.push_back(core::as_danger(text));
}

}  // namespace

void tell_of_ice_above(Plan& plan, const PlanRequest& request) {
  warn_of_start_and_goal(plan);
  warn_of_vias_under_ice(plan, request);
  warn_of_long_below_ice(plan, request);
}

}  // namespace floeplan::planning::publish

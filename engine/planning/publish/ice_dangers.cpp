#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/planning/publish/warnings.hpp"

namespace floeplan::planning::publish {
namespace {

/// Whether a place is under ice. Unknown ice over a place that was open when last known does not count.
bool lies_under_ice(const SurfacingState& state) {
  return !state.may_surface && state.least_upper_turn.value > 0.0;
}

void tell_of_start_and_goal(Plan& plan) {
  const SurfacingState& start = plan.surfacing->waypoints.front();
  const SurfacingState& goal = plan.surfacing->waypoints.back();
  if (!start.may_surface) {
    plan.messages.push_back((lies_under_ice(start) ? messages::plan_message<"start-under-ice">()
                                                   : messages::plan_message<"start-ice-unknown">())
                                .at(plan.waypoints.front().place));
  }
  if (!goal.may_surface) {
    plan.messages.push_back((lies_under_ice(goal) ? messages::plan_message<"goal-under-ice">()
                                                  : messages::plan_message<"goal-ice-unknown">())
                                .at(plan.waypoints.back().place));
  }
}

/// Via points are waypoints of the plan, so their ice is taken from there.
void tell_of_vias_under_ice(Plan& plan, const PlanRequest& request) {
  constexpr core::Metres same_place{1.0};
  constexpr std::size_t most_named = 10;
  std::string under;
  std::size_t count = 0;
  std::optional<geo::LonLat> first;
  for (std::size_t i = 0; i < request.via.size(); ++i) {
    const auto is_under = [&](std::size_t waypoint) {
      return lies_under_ice(plan.surfacing->waypoints[waypoint]) &&
             geo::geodesic_between(plan.waypoints[waypoint].place, request.via[i]).length < same_place;
    };
    std::size_t waypoint = 0;
    while (waypoint < plan.waypoints.size() && !is_under(waypoint)) ++waypoint;
    if (waypoint == plan.waypoints.size()) continue;
    if (!first) first = request.via[i];
    if (count++ < most_named) under += (under.empty() ? "" : ", ") + std::to_string(i + 1);
  }
  if (count == 0) return;
  if (count > most_named) under += " and more";
  plan.messages.push_back(
      messages::plan_message<"vias-under-ice">(count, request.via.size(), under).at(*first));
}

/// The longest time without contact in missions in use: after it at the latest they order a surfacing for
/// lack of contact.
/// Source   when_secs of the surface behaviors for start_when 12 in the missions published for deep Slocums,
///          5 to 12 h
constexpr core::Seconds longest_out_of_contact{43200.0};

/// No message if the pilot limits that time, and so has decided how long it may be. Place of the message: the
/// beginning of the first leg below ice.
void tell_of_long_below_ice(Plan& plan, const PlanRequest& request) {
  const core::Seconds longest = plan.surfacing->longest_without;
  const auto& states = plan.surfacing->waypoints;
  const auto first = std::ranges::find_if(states, [](const SurfacingState& state) {
    return state.leg_upper_turn.value_or(core::Metres{0.0}).value > 0.0;
  });
  if (request.under_ice.max_time_without_surfacing || first == states.end() ||
      longest <= longest_out_of_contact)
    return;
  const auto arrives = static_cast<std::size_t>(first - states.begin());
  const Waypoint& begin = plan.waypoints[arrives > 0 ? arrives - 1 : 0];
  plan.messages.push_back(messages::plan_message<"long-below-ice">(longest.count() / 3600.0).at(begin.place));
}

/// The message for a vehicle that misses the leads narrower than its position error, if its time below ice is
/// then longer by an hour.
void tell_of_missed_leads(Plan& plan, const PlanRequest& request) {
  const core::Seconds sure = plan.surfacing->longest_without_sure;
  const double sure_h = sure.count() / 3600.0;
  const double longest_h = plan.surfacing->longest_without.count() / 3600.0;
  if (request.under_ice.max_time_without_surfacing || sure <= longest_out_of_contact ||
      std::round(sure_h) <= std::round(longest_h))
    return;
  plan.messages.push_back(messages::plan_message<"longer-below-ice-without-leads">(sure_h, longest_h));
  plan.messages.back().place = plan.surfacing->missed_lead;
}

}  // namespace

void tell_of_ice_above(Plan& plan, const PlanRequest& request) {
  tell_of_start_and_goal(plan);
  tell_of_vias_under_ice(plan, request);
  tell_of_long_below_ice(plan, request);
  tell_of_missed_leads(plan, request);
}

}  // namespace floeplan::planning::publish

#include "engine/mission/writing/below_ice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/messages/export_messages.hpp"
#include "engine/mission/writing/argument_lines.hpp"
#include "engine/mission/writing/waypoint_ranges.hpp"

namespace floeplan::mission {
namespace {

/// Whether the vehicle can surface nowhere on the leg, its end included.
bool has_no_opening(const planning::Plan& plan, std::size_t waypoint) {
  constexpr core::Seconds rounding{1.0};  // rounding of stored times
  const planning::SurfacingState& state = plan.surfacing->waypoints[waypoint];
  const planning::Waypoint& from = plan.waypoints[waypoint - 1];
  const core::Seconds under_way = plan.waypoints[waypoint].eta - (from.eta + from.wait);
  return !state.may_surface && state.since_surfacing + rounding >= under_way;
}

/// Whether ice may be the reason for the upper turn on the leg to this waypoint: the plan has ice data, or
/// the leg passes under no iceberg.
bool may_be_below_ice(const planning::Plan& plan, std::size_t waypoint) {
  const core::UtcTime from = plan.waypoints[waypoint == 0 ? 0 : waypoint - 1].eta;
  const core::UtcTime until = plan.waypoints[waypoint].eta + plan.waypoints[waypoint].wait;
  const bool below_iceberg = std::ranges::any_of(plan.passed_under, [&](const planning::PassedUnder& under) {
    return under.from <= until && from <= under.until;
  });
  return !below_iceberg ||
         std::ranges::find(plan.datasets, "ice", &ocean::DatasetRef::kind) != plan.datasets.end();
}

}  // namespace

core::Metres least_upper_turn(const planning::Plan& plan) {
  core::Metres deepest{0.0};
  for (const planning::PassedUnder& under : plan.passed_under)
    deepest = std::max(deepest, under.keel.upper_turn);
  if (!plan.surfacing) return deepest;
  for (const planning::SurfacingState& state : plan.surfacing->waypoints)
    deepest = std::max({deepest, state.least_upper_turn, state.leg_upper_turn.value_or(core::Metres{0.0})});
  return deepest;
}

core::Metres deepest_keel(const planning::Plan& plan, core::Metres margin_below_ice) {
  core::Metres deepest{0.0};
  for (const planning::PassedUnder& under : plan.passed_under)
    deepest = std::max(deepest, under.keel.deepest);
  if (!plan.surfacing) return deepest;
  for (std::size_t i = 0; i < plan.surfacing->waypoints.size(); ++i) {
    if (!may_be_below_ice(plan, i)) continue;
    const planning::SurfacingState& state = plan.surfacing->waypoints[i];
    const core::Metres turn =
        std::max(state.least_upper_turn, state.leg_upper_turn.value_or(core::Metres{0.0}));
    if (turn.value > 0.0) deepest = std::max(deepest, turn - margin_below_ice);
  }
  return deepest;
}

Overhead overhead(const planning::Plan& plan, std::size_t waypoint) {
  const core::UtcTime arrival = plan.waypoints[waypoint].eta;
  const core::UtcTime departure = arrival + plan.waypoints[waypoint].wait;
  const bool below_iceberg = std::ranges::any_of(plan.passed_under, [&](const planning::PassedUnder& under) {
    return under.from <= departure && arrival <= under.until;
  });
  if (below_iceberg) return Overhead::closed;
  if (!plan.surfacing || plan.surfacing->waypoints[waypoint].may_surface) return Overhead::open;
  return plan.surfacing->waypoints[waypoint].least_upper_turn.value > 0.0 ? Overhead::closed
                                                                          : Overhead::unknown;
}

bool may_surface_everywhere(const planning::Plan& plan) {
  return plan.passed_under.empty() && least_upper_turn(plan).value == 0.0 &&
         (!plan.surfacing || plan.surfacing->longest_without.count() <= 0.0);
}

bool tells_upper_turns(const planning::Plan& plan) {
  if (!plan.surfacing || plan.surfacing->longest_without.count() <= 0.0) return true;
  const auto& waypoints = plan.surfacing->waypoints;
  return std::all_of(waypoints.begin() + 1, waypoints.end(),
                     [](const planning::SurfacingState& state) { return state.leg_upper_turn.has_value(); });
}

std::vector<std::string> closed_above_since(const planning::Plan& plan, const planning::Plan& now) {
  std::vector<std::string> found;
  const double planned_m = std::ceil(least_upper_turn(plan).value);
  const double needed_m = std::ceil(least_upper_turn(now).value);
  if (needed_m > planned_m) {
    found.push_back("the route passes below ice or icebergs, where the upper turn must be at " +
                    whole(needed_m) + " m or deeper. The plan was made for " +
                    (planned_m > 0.0 ? whole(planned_m) + " m" : std::string{"open water"}));
  }
  if (plan.waypoints.size() != now.waypoints.size()) return found;
  const std::string closed = waypoint_ranges(plan.waypoints.size(), [&](std::size_t i) {
    return overhead(plan, i) != Overhead::closed && overhead(now, i) == Overhead::closed;
  });
  if (!closed.empty())
    found.push_back("the vehicle must not surface at waypoints " + closed + ", although the plan allows it");
  return found;
}

std::vector<messages::Message> warnings_below_ice(const planning::Plan& plan) {
  std::vector<messages::Message> told;
  if (!plan.surfacing) return told;
  const planning::SurfacingPlan& surfacing = *plan.surfacing;
  const std::string below = waypoint_ranges(surfacing.waypoints.size(), [&](std::size_t i) {
    return surfacing.waypoints[i].leg_upper_turn.value_or(core::Metres{0.0}).value > 0.0;
  });
  if (!below.empty()) {
    told.push_back(
        messages::export_message<"files-pass-below-ice">(below, std::ceil(least_upper_turn(plan).value)));
  }
  const std::string closed =
      waypoint_ranges(surfacing.waypoints.size(), [&](std::size_t i) { return has_no_opening(plan, i); });
  if (!closed.empty()) told.push_back(messages::export_message<"nowhere-to-surface">(closed));
  if (!tells_upper_turns(plan)) told.push_back(messages::export_message<"upper-turns-not-told">());
  if (surfacing.unknown_ice.value > 0.0)
    told.push_back(messages::export_message<"files-in-unknown-ice">(surfacing.unknown_ice.value / 1000.0));
  return told;
}

}  // namespace floeplan::mission

#include "engine/mission/writing/list_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/core/shown_text.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "engine/mission/writing/hold_lists.hpp"
#include "engine/motion/speed_over_ground.hpp"

namespace floeplan::mission {
namespace {

std::string waypoints_text(std::size_t first, std::size_t last) {
  return first == last ? "waypoint " + std::to_string(first)
                       : "waypoints " + std::to_string(first) + " to " + std::to_string(last);
}

core::Metres length_of(const planning::Plan& plan, const ListPart& part) {
  core::Metres length{0.0};
  for (std::size_t i = part.first; i <= part.last; ++i)
    length = length + plan.waypoints[i].leg_length.value_or(core::Metres{0.0});
  return length;
}

/// Distance along the list's route from the last iceberg that it passes under to the list's end; empty if
/// there is none.
std::optional<core::Metres> beyond_iceberg(const planning::Plan& plan, const ListPart& part) {
  std::optional<core::Metres> least;
  const core::UtcTime begins = plan.waypoints[part.first - 1].eta;
  for (const planning::PassedUnder& under : plan.passed_under) {
    core::Metres beyond{0.0};
    std::size_t leg = part.last;
    for (; leg >= part.first && under.until < plan.waypoints[leg - 1].eta; --leg)
      beyond = beyond + plan.waypoints[leg].leg_length.value_or(core::Metres{0.0});
    if (leg < part.first || under.until < begins || under.from > plan.waypoints[part.last].eta) continue;
    const core::Seconds after = plan.waypoints[leg].eta - under.until;
    const core::MetresPerSecond speed =
        plan.waypoints[leg].speed_over_ground.value_or(core::MetresPerSecond{});
    beyond = beyond + core::Metres{speed.value * std::max(0.0, after.count())};
    least = least ? std::min(*least, beyond) : beyond;
  }
  return least;
}

core::Seconds planned_time(const planning::Plan& plan, std::size_t leg) {
  const planning::Waypoint& from = plan.waypoints[leg - 1];
  return plan.waypoints[leg].eta - (from.eta + from.wait);
}

/// Time under way on a leg: the planned time, or the time with the assumed current if that is longer.
core::Seconds time_under_way(const planning::Plan& plan, std::size_t number, geo::VelocityEn reckoned) {
  const core::Seconds planned = planned_time(plan, number);
  const planning::Waypoint& leg = plan.waypoints[number];
  if (!leg.course_deg || !leg.leg_length || !leg.speed_through_water) return planned;
  const auto speed =
      motion::speed_over_ground(*leg.speed_through_water, reckoned, geo::Bearing::degrees(*leg.course_deg));
  return speed ? std::max(planned, *leg.leg_length / *speed) : planned;
}

/// A span of the plan's time.
struct Span {
  core::UtcTime from;
  core::UtcTime until;
};

/// Share of the time under way on the leg to a waypoint that lies in the span.
double share_within(const planning::Plan& plan, std::size_t leg, const Span& span) {
  const core::UtcTime begin = plan.waypoints[leg - 1].eta + plan.waypoints[leg - 1].wait;
  const core::UtcTime end = plan.waypoints[leg].eta;
  if (span.from <= begin && end <= span.until) return 1.0;
  if (span.until <= begin || end <= span.from) return 0.0;
  return (std::min(end, span.until) - std::max(begin, span.from)) / (end - begin);
}

/// Mean current over the legs within the span. A leg whose current the plan does not state counts as without
/// current.
geo::VelocityEn mean_current(const planning::Plan& plan, const Span& span) {
  double east_m = 0.0;
  double north_m = 0.0;
  double all_s = 0.0;
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    const geo::VelocityEn current = plan.waypoints[i].current.value_or(geo::VelocityEn{});
    const double time_s = share_within(plan, i, span) * planned_time(plan, i).count();
    east_m += current.east.value * time_s;
    north_m += current.north.value * time_s;
    all_s += time_s;
  }
  if (all_s <= 0.0) return {};
  return {{east_m / all_s}, {north_m / all_s}};
}

/// When the vehicle leaves the start of the list, with a fix.
core::UtcTime begin_of(const planning::Plan& plan, const ListPart& part) {
  const planning::Waypoint& start = plan.waypoints[part.first - 1];
  return start.eta + start.wait;
}

/// The current that the vehicle navigates with at first: its estimate from the last dives.
geo::VelocityEn assumed_at_start(const planning::Plan& plan, const ListPart& part) {
  if (part.before == 0) return {};
  const core::UtcTime surfaced = plan.waypoints[part.first - 1].eta;
  core::UtcTime from = plan.waypoints[part.before - 1].eta;
  if (part.between_fixes) from = std::max(from, surfaced - *part.between_fixes);
  return mean_current(plan, {from, surfaced});
}

/// The last time under way without a fix, and the current that the vehicle navigates with then.
struct LastDives {
  Span span;
  geo::VelocityEn assumed;
};

LastDives last_dives(const planning::Plan& plan, const ListPart& part) {
  const core::UtcTime begin = begin_of(plan, part);
  const core::UtcTime end = plan.waypoints[part.last].eta;
  if (!part.between_fixes || end - begin <= *part.between_fixes)
    return {{begin, end}, assumed_at_start(plan, part)};
  const core::UtcTime fix = end - *part.between_fixes;
  return {{fix, end}, mean_current(plan, {std::max(begin, fix - *part.between_fixes), fix})};
}

/// How far the currents carry the vehicle since its last fix, relative to the current with which it navigates
/// (`dives.assumed`).
core::Metres carried_off(const planning::Plan& plan, const ListPart& part, const LastDives& dives) {
  double east_m = 0.0;
  double north_m = 0.0;
  for (std::size_t i = part.first; i <= part.last; ++i) {
    const planning::Waypoint& leg = plan.waypoints[i];
    if (!leg.current) continue;
    const double time_s = share_within(plan, i, dives.span) * time_under_way(plan, i, dives.assumed).count();
    east_m += (leg.current->east - dives.assumed.east).value * time_s;
    north_m += (leg.current->north - dives.assumed.north).value * time_s;
  }
  return {std::hypot(east_m, north_m)};
}

/// Position error at `time` on the list's route, as if there had been no position fix since the plan's start.
/// Linear within each leg; nullopt if the error is unknown at an end of the leg.
std::optional<core::Metres> error_without_fix_at(const planning::Plan& plan, const ListPart& part,
                                                 core::UtcTime time) {
  const auto& states = plan.surfacing->waypoints;
  const core::UtcTime begin = begin_of(plan, part);
  if (time <= begin) return states[part.first - 1].error_without_fix;
  std::size_t leg = part.first;
  while (leg < part.last && plan.waypoints[leg].eta < time) ++leg;
  const auto& before = states[leg - 1].error_without_fix;
  const auto& after = states[leg].error_without_fix;
  if (!before || !after) return std::nullopt;
  return *before + share_within(plan, leg, {begin, time}) * (*after - *before);
}

/// Whether the list may end at its last waypoint: nothing is above the vehicle there, and the `room` of its
/// ListEnd is larger than `radius`, or it has no ListEnd.
bool has_room(const planning::Plan& plan, const ListPart& part, core::Metres (ListEnd::*room)() const,
              core::Metres radius) {
  if (overhead(plan, part.last) != Overhead::open) return false;
  const auto end = end_of(plan, part);
  return !end || ((*end).*room)() > radius;
}

/// The last waypoint of the list that begins at waypoint `first`.
std::size_t last_of_list(const planning::Plan& plan, std::size_t first, std::size_t before,
                         const ListRules& rules) {
  const std::size_t longest = std::min(first + rules.max_waypoints, plan.waypoints.size()) - 1;
  std::size_t farthest = first;
  while (farthest < longest && !is_held_at(plan, farthest)) ++farthest;
  if (is_held_at(plan, farthest) &&
      has_room(plan, {first, farthest, before, rules.between_fixes}, &ListEnd::room, rules.radius))
    return farthest;
  const auto farthest_where = [&](const auto& suits) -> std::optional<std::size_t> {
    for (std::size_t last = farthest; last >= first; --last)
      if (suits(last)) return last;
    return std::nullopt;
  };
  for (const auto room : {&ListEnd::sure_room, &ListEnd::room}) {
    if (const auto last = farthest_where([&](std::size_t i) {
          return has_room(plan, {first, i, before, rules.between_fixes}, room, rules.radius);
        }))
      return *last;
  }
  for (const Overhead wanted : {Overhead::unknown, Overhead::open}) {
    if (const auto last = farthest_where([&](std::size_t i) { return overhead(plan, i) == wanted; }))
      return *last;
  }
  return farthest;
}

/// `is_end`: the end of the plan.
core::Violation end_too_near(const std::string& place, const ListEnd& end, core::Metres radius, bool is_end) {
  const std::string room = text_of(end, radius);
  const double beyond_m = told_upwards(radius).value;
  return is_end ? messages::mission_fault<"plan-ends-near-ice">(place, room, beyond_m)
                : messages::mission_fault<"list-ends-near-ice">(place, room, beyond_m);
}

}  // namespace

bool passes_below(const planning::Plan& plan, const ListPart& part) {
  if (!plan.surfacing) return false;
  for (std::size_t i = part.first; i <= part.last; ++i) {
    const planning::SurfacingState& state = plan.surfacing->waypoints[i];
    if (state.leg_upper_turn.value_or(state.least_upper_turn).value > 0.0) return true;
  }
  return false;
}

core::Metres error_of(const planning::Plan& plan, const ListPart& part) {
  if (!plan.surfacing) return {};
  const LastDives dives = last_dives(plan, part);
  const auto at_fix = error_without_fix_at(plan, part, dives.span.from);
  const auto& at_end = plan.surfacing->waypoints[part.last].error_without_fix;
  if (!at_fix || !at_end) return {};
  return *at_end - *at_fix + carried_off(plan, part, dives);
}

core::Seconds late_by(const planning::Plan& plan, const ListPart& part) {
  const geo::VelocityEn assumed = assumed_at_start(plan, part);
  const core::UtcTime begin = begin_of(plan, part);
  const core::UtcTime end = plan.waypoints[part.last].eta;
  const Span until_fix{begin, part.between_fixes ? std::min(end, begin + *part.between_fixes) : end};
  core::Seconds late{0.0};
  for (std::size_t i = part.first; i <= part.last; ++i) {
    if (plan.waypoints[i].current)
      late += share_within(plan, i, until_fix) * (time_under_way(plan, i, assumed) - planned_time(plan, i));
  }
  return late;
}

core::Metres ListEnd::room() const {
  core::Metres least{std::numeric_limits<double>::infinity()};
  if (beyond_ice) least = *beyond_ice;
  if (beyond_iceberg) least = std::min(least, *beyond_iceberg);
  return least;
}

core::Metres ListEnd::sure_room() const {
  core::Metres least = room();
  for (const auto& ice : {beyond_ice, from_ice})
    if (ice) least = std::min(least, *ice - error);
  return least;
}

std::optional<ListEnd> end_of(const planning::Plan& plan, const ListPart& part) {
  const bool is_near = plan.surfacing && plan.surfacing->waypoints[part.last].nearest_ice;
  if (!is_near && !passes_below(plan, part)) return std::nullopt;
  const planning::SurfacingState& before = plan.surfacing->waypoints[part.first - 1];
  const planning::SurfacingState& last = plan.surfacing->waypoints[part.last];
  if (!last.ice_free_before || !last.error_without_fix || !before.error_without_fix) return std::nullopt;
  ListEnd end{.beyond_iceberg = beyond_iceberg(plan, part),
              .from_ice = last.nearest_ice,
              .error = error_of(plan, part)};
  // The ice-free length before the end was summed up in the plane, the legs' lengths on the ellipsoid. Hence
  // a tolerance.
  constexpr double as_long = 1.001;
  if (as_long * *last.ice_free_before < length_of(plan, part)) end.beyond_ice = *last.ice_free_before;
  return end;
}

std::string text_of(const ListEnd& end, core::Metres radius) {
  std::string text;
  const auto add = [&](const std::optional<core::Metres>& beyond, const char* what) {
    if (beyond)
      text += (text.empty() ? "" : " and ") + core::distance_text(*beyond) + " beyond the " + what;
  };
  add(end.beyond_ice, "ice");
  add(end.beyond_iceberg, "iceberg");
  if (end.from_ice)
    text += (text.empty() ? "" : " and ") + core::distance_text(*end.from_ice) + " from the nearest ice";
  text += " (waypoint radius " + core::distance_text(radius);
  if (end.beyond_ice || end.from_ice) text += ", position error " + core::distance_text(end.error);
  return text + ")";
}

core::Metres told_upwards(core::Metres least) {
  const double step_m = least.value < 1000.0 ? 1.0 : 100.0;
  return {step_m * std::ceil(least.value / step_m)};
}

std::vector<ListPart> part_into_lists(const planning::Plan& plan, const ListRules& rules) {
  std::vector<ListPart> parts;
  std::size_t before = 0;
  for (std::size_t first = 1; first < plan.waypoints.size();) {
    parts.push_back({first, last_of_list(plan, first, before, rules), before, rules.between_fixes});
    before = first;
    first = parts.back().last + 1;
  }
  return parts;
}

core::Violations list_end_violations(const planning::Plan& plan, const ListRules& rules) {
  core::Violations found;
  const std::size_t count = plan.waypoints.size();
  std::size_t told = 0;  // last waypoint below ice that a violation names
  for (const ListPart& part : part_into_lists(plan, rules)) {
    const bool is_end = part.last + 1 == count;
    const Overhead above = overhead(plan, part.last);
    const std::string place = "/waypoints/" + std::to_string(part.last);
    if (above == Overhead::open && !has_room(plan, part, &ListEnd::room, rules.radius))
      found.push_back(end_too_near(place, *end_of(plan, part), rules.radius, is_end));
    if (above != Overhead::closed) continue;
    if (is_end) found.push_back(messages::mission_fault<"plan-ends-below-ice">(place));
    if (is_end || part.last <= told) continue;
    told = part.last;
    while (told + 1 < count && overhead(plan, told + 1) == Overhead::closed) ++told;
    found.push_back(messages::mission_fault<"too-many-waypoints-below-ice">(
        "/waypoints", waypoints_text(part.first, told), rules.max_waypoints));
  }
  return found;
}

}  // namespace floeplan::mission

#include "engine/mission/writing/goto_lists.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/geo/geodesic.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/fault.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/mission/document/hold_order.hpp"
#include "engine/mission/document/printed_text.hpp"
#include "engine/mission/writing/argument_lines.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "engine/mission/writing/list_parts.hpp"
#include "engine/mission/writing/waypoint_ranges.hpp"

namespace floeplan::mission {
namespace {

constexpr int documented_max_waypoints = 8;
constexpr double max_latitude_deg = 89.0;   // nearer to a pole the vehicle's UTM-based metres are useless
constexpr double utm_north_end_deg = 84.0;  // UTM is defined between these parallels
constexpr double utm_south_end_deg = -80.0;
constexpr double smallest_radius_m = 10.0;  // minimum of list_when_wpt_dist in the vehicle's data dictionary
constexpr double largest_default_radius_m = 500.0;
constexpr double long_leg_m = 100'000.0;
// Judgements: larger errors are more than pilots expect of dead reckoning. A plan still knows the ice within
// this distance.
constexpr core::Metres far_off{5000.0};
constexpr core::Seconds far_later{2.0 * 3600.0};

std::vector<core::Metres> leg_lengths(const planning::Plan& plan) {
  std::vector<core::Metres> lengths;
  for (std::size_t i = 1; i < plan.waypoints.size(); ++i) {
    lengths.push_back(geo::geodesic_between(plan.waypoints[i - 1].place, plan.waypoints[i].place).length);
  }
  return lengths;
}

/// The rules for dividing a plan into lists. A list that ends near ice gets a smaller radius, unless one is
/// requested.
ListRules rules_of(const GotoListOptions& options) {
  return {static_cast<std::size_t>(options.max_waypoints),
          options.radius.value_or(core::Metres{smallest_radius_m}), options.between_fixes};
}

core::Metres radius_of(const planning::Plan& plan, const ListPart& part, const GotoListOptions& options) {
  if (options.radius) return {std::floor(options.radius->value)};
  core::Metres usual = default_waypoint_radius(plan);
  if (is_held_at(plan, part.last)) usual = std::min(usual, turning_radius(options.holds.radius));
  const auto end = end_of(plan, part);
  if (!end) return usual;
  const bool is_sure = end->sure_room().value > smallest_radius_m;
  core::Metres room = is_sure ? end->sure_room() : end->room();
  if (end->from_ice) room = std::min(room, *end->from_ice);
  return {std::clamp(std::ceil(room.value) - 1.0, smallest_radius_m, usual.value)};
}

/// A file of the set: some of the plan's waypoints with their radius, or the hold at the last of them.
struct List {
  std::string file_name;
  ListPart part;
  core::Metres radius;
  std::optional<HoldLegs> hold{};
};

/// The first list that has waypoints; a hold at the start comes before it.
const List& first_with_waypoints(const std::vector<List>& lists) {
  return lists.front().hold ? lists[1] : lists.front();
}

std::vector<List> lists_of_plan(const planning::Plan& plan, const GotoListOptions& options) {
  std::vector<List> lists;
  const auto next_name = [&] {
    return argument_file_name("goto_list", options.first_number + static_cast<int>(lists.size()));
  };
  const auto hold_at = [&](std::size_t waypoint) {
    if (!is_held_at(plan, waypoint)) return;
    if (const auto legs = hold_legs(hold_flight(plan, waypoint, options.holds)))
      lists.push_back({next_name(), {waypoint, waypoint}, legs->radius, legs});
  };
  hold_at(0);
  for (const ListPart& part : part_into_lists(plan, rules_of(options))) {
    lists.push_back({next_name(), part, radius_of(plan, part, options)});
    hold_at(part.last);
  }
  return lists;
}

core::Violations violations_of_options(const planning::Plan& plan, const GotoListOptions& options) {
  core::Violations found;
  if (plan.waypoints.size() < 2) found.push_back(messages::mission_fault<"no-start-and-goal">("/waypoints"));
  for (std::size_t i = 0; i < plan.waypoints.size(); ++i) {
    const geo::LonLat place = plan.waypoints[i].place;
    if (!geo::is_valid(place) || std::abs(place.lat_deg) > max_latitude_deg) {
      found.push_back(messages::mission_fault<"waypoint-near-pole">("/waypoints/" + std::to_string(i)));
    }
  }
  if (options.max_waypoints < 1) found.push_back(messages::fault<"not-at-least">("/max_waypoints", "1"));
  if (options.radius && !(options.radius->value >= smallest_radius_m && options.radius->value <= 100'000.0)) {
    found.push_back(messages::mission_fault<"wrong-waypoint-radius">("/radius_m"));
  }
  if (!found.empty()) return found;

  if (!options.may_end_below_ice) found = list_end_violations(plan, rules_of(options));
  return found;
}

/// Violations of the rules for file numbers.
core::Violations violations_of_numbers(const std::vector<List>& lists, const GotoListOptions& options) {
  core::Violations found;
  const auto count = static_cast<int>(lists.size());
  if (options.first_number < 0 || options.first_number + count - 1 > last_free_number) {
    found.push_back(messages::mission_fault<"list-numbers-used-up">("/number", count));
  }
  const auto rows_of_first = static_cast<int>(first_with_waypoints(lists).part.last);
  if (options.initial_waypoint < -2 || options.initial_waypoint >= rows_of_first) {
    found.push_back(messages::mission_fault<"no-such-row">("/initial_waypoint"));
  }
  return found;
}

/// Whether the plan passes below ice or icebergs, or has ice near one of its waypoints.
bool is_beside_ice(const planning::Plan& plan) {
  const auto is_near = [](const planning::SurfacingState& state) { return state.nearest_ice.has_value(); };
  return passes_below(plan, {1, plan.waypoints.size() - 1}) ||
         (plan.surfacing && std::ranges::any_of(plan.surfacing->waypoints, is_near));
}

/// The message if the vehicle may be unable to surface at the end of the list; otherwise empty.
std::optional<messages::Message> message_of_end(const planning::Plan& plan, const List& list) {
  const std::size_t last = list.part.last;
  const auto told = [&]() -> std::optional<messages::Message> {
    if (overhead(plan, last) == Overhead::unknown)
      return messages::export_message<"list-ends-in-unknown-ice">(list.file_name, last);
    const auto end = end_of(plan, list.part);
    if (!end && !passes_below(plan, list.part)) {
      const core::Metres error = error_of(plan, list.part);
      if (error <= far_off) return std::nullopt;
      return messages::export_message<"list-ends-far-off">(list.file_name, last,
                                                           error.value / 1000.0);
    }
    if (!end) return messages::export_message<"list-ends-after-ice-of-earlier-version">(list.file_name, last);
    const std::string room = text_of(*end, list.radius);
    if (end->sure_room() <= list.radius) {
      return messages::export_message<"list-may-end-below-ice">(list.file_name, last, room,
                                                                told_upwards(list.radius + end->error).value);
    }
    if (!passes_below(plan, list.part)) return std::nullopt;
    return messages::export_message<"list-ends-beside-ice">(list.file_name, last, room);
  };
  auto message = told();
  if (message) message->place = plan.waypoints[last].place;
  return message;
}

/// The message if the list takes longer than planned, so that its end may be under ice by then; otherwise
/// empty.
std::optional<messages::Message> message_of_delay(const planning::Plan& plan, const List& list) {
  const core::Seconds late = late_by(plan, list.part);
  if (!plan.surfacing || late <= far_later) return std::nullopt;
  return messages::export_message<"list-flown-longer">(list.file_name, late.count() / 3600.0)
      .at(plan.waypoints[list.part.last].place);
}

/// The message if the plan has legs with the thruster but no file turns it on; otherwise empty.
std::optional<messages::Message> message_of_thruster(const planning::Plan& plan,
                                                     const GotoListOptions& options) {
  if (options.thruster_in_yo) return std::nullopt;
  const std::string on_thruster = waypoint_ranges(plan.waypoints.size(), [&](std::size_t i) {
    return plan.waypoints[i].drive == vehicle::Drive::thruster;
  });
  if (on_thruster.empty()) return std::nullopt;
  return messages::export_message<"thruster-not-in-files">(on_thruster);
}

/// The message if a stored plan lacks the currents of its legs and the lists need them; empty otherwise.
std::optional<messages::Message> message_of_unknown_currents(const planning::Plan& plan) {
  const auto is_water = [](const ocean::DatasetRef& dataset) {
    return dataset.kind == "currents" || dataset.kind == "tides";
  };
  const bool is_told = std::ranges::any_of(
      plan.waypoints, [](const planning::Waypoint& waypoint) { return waypoint.current.has_value(); });
  if (is_told || !is_beside_ice(plan) || std::ranges::none_of(plan.datasets, is_water)) return std::nullopt;
  return messages::export_message<"currents-of-legs-not-told">();
}

/// The message about the first dives: before its first surfacing a vehicle has no estimate of the current.
/// Empty if the plan passes below no ice.
std::optional<messages::Message> message_of_first_dives(const planning::Plan& plan, const List& first) {
  if (!passes_below(plan, {1, plan.waypoints.size() - 1})) return std::nullopt;
  const planning::Waypoint& start = plan.waypoints.front();
  const core::Seconds time = plan.waypoints[first.part.last].eta - (start.eta + start.wait);
  return messages::export_message<"long-before-first-surfacing">(first.file_name, time.count() / 3600.0,
                                                                 0.1 * time.count() / 1000.0);
}

/// The message on how the hold at a waypoint is flown and what the pilot must do; empty: no hold worth
/// mentioning.
std::optional<messages::Message> message_of_hold(const planning::Plan& plan, const std::vector<List>& lists,
                                                 std::size_t waypoint) {
  const planning::Waypoint& place = plan.waypoints[waypoint];
  if (place.wait < least_listed_hold) return std::nullopt;
  const double wait_h = place.wait.count() / 3600.0;
  const core::UtcTime release = place.eta + place.wait;
  const auto list =
      std::ranges::find_if(lists, [&](const List& each) { return each.hold && each.part.last == waypoint; });
  const auto told = [&] {
    if (list == lists.end()) {
      const bool ends_there = waypoint == 0 || std::ranges::any_of(lists, [&](const List& each) {
                                return each.part.last == waypoint;
                              });
      return ends_there ? messages::export_message<"hold-shorter-than-list">(wait_h, waypoint, release)
                        : messages::export_message<"hold-not-in-lists">(wait_h, waypoint);
    }
    const std::string& next = std::next(list)->file_name;
    if (list->hold->legs < 0)
      return messages::export_message<"hold-list-without-end">(list->file_name, waypoint, wait_h, next,
                                                               release);
    return messages::export_message<"hold-list">(list->file_name, waypoint, list->hold->legs,
                                                 list->hold->expected.count() / 3600.0, next, release);
  };
  return told().at(place.place);
}

std::vector<messages::Message> messages_for(const planning::Plan& plan, const GotoListOptions& options,
                                            const std::vector<core::Metres>& legs,
                                            const std::vector<List>& lists) {
  std::vector<messages::Message> told;
  const auto tell = [&](std::optional<messages::Message> message) {
    if (message) told.push_back(std::move(*message));
  };
  const auto holds = std::ranges::count_if(lists, [](const List& list) { return list.hold.has_value(); });
  if (holds > 0) {
    tell(messages::export_message<"lists-with-holds">(lists.size(), holds, lists.front().file_name,
                                                      lists.back().file_name));
  } else if (lists.size() > 1) {
    tell(messages::export_message<"several-lists">(lists.size(), lists.front().file_name,
                                                   lists.back().file_name, options.max_waypoints));
  }
  tell(message_of_thruster(plan, options));
  tell(message_of_unknown_currents(plan));
  tell(message_of_first_dives(plan, first_with_waypoints(lists)));
  for (const List& list : lists) {
    if (list.hold) continue;
    tell(message_of_end(plan, list));
    tell(message_of_delay(plan, list));
  }
  if (options.max_waypoints > documented_max_waypoints)
    tell(messages::export_message<"lists-longer-than-documented">(options.max_waypoints));
  double radius_m = 0.0;
  for (const List& list : lists)
    if (!list.hold) radius_m = std::max(radius_m, list.radius.value);
  const core::Metres shortest = *std::min_element(legs.begin(), legs.end());
  if (radius_m >= shortest.value / 2.0)
    tell(messages::export_message<"waypoint-radius-too-large">(radius_m, shortest.value));
  const auto tell_of_short_cut = [&](const std::optional<core::Metres>& clearance, const char* what) {
    if (!clearance || clearance->value >= radius_m) return;
    tell(messages::export_message<"corners-may-be-cut">(radius_m, what, clearance->value));
  };
  tell_of_short_cut(plan.clearances.iceberg, "an iceberg");
  tell_of_short_cut(plan.clearances.land, "land");
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (legs[i].value <= long_leg_m) continue;
    tell(messages::export_message<"long-leg">(i + 1, legs[i].value / 1000.0).at(plan.waypoints[i + 1].place));
  }
  for (const planning::PassedUnder& under : plan.passed_under) {
    tell(messages::export_message<"files-pass-under-iceberg">(under.iceberg, under.from, under.until,
                                                              std::ceil(under.keel.upper_turn.value)));
  }
  std::ranges::move(warnings_below_ice(plan), std::back_inserter(told));
  for (std::size_t i = 0; i + 1 < plan.waypoints.size(); ++i) tell(message_of_hold(plan, lists, i));
  const auto beyond_utm = std::ranges::find_if(plan.waypoints, [](const planning::Waypoint& w) {
    return w.place.lat_deg > utm_north_end_deg || w.place.lat_deg < utm_south_end_deg;
  });
  if (beyond_utm != plan.waypoints.end())
    tell(messages::export_message<"beyond-utm">().at(beyond_utm->place));
  return told;
}

/// Duration of the list without the hold before it, during which the pilot has contact.
core::Seconds time_of(const planning::Plan& plan, const ListPart& part) {
  const planning::Waypoint& from = plan.waypoints[part.first - 1];
  return plan.waypoints[part.last].eta - (from.eta + from.wait);
}

std::string goto_list_text(const std::string& comments, int legs, core::Metres radius, int initial,
                           const std::vector<geo::LonLat>& places) {
  return argument_file("goto_list", comments,
                       {{"num_legs_to_run", whole(legs)},
                        {"start_when", "0"},
                        {"list_stop_when", "7"},
                        {"list_when_wpt_dist", whole(radius.value)},
                        {"initial_wpt", whole(initial)},
                        {"num_waypoints", whole(static_cast<double>(places.size()))}}) +
         waypoint_section(places);
}

std::string list_text(const planning::Plan& plan, const List& list, const std::string& head, int initial,
                      const GotoListOptions& options) {
  constexpr int once = -2;
  const ListPart& part = list.part;
  const std::string comments =
      head + print("waypoints %zu to %zu of %zu\n", part.first, part.last, plan.waypoints.size() - 1) +
      origin_comments(plan, options.origin) +
      "# The start of the plan is left out: the vehicle is there and heads for the first row.\n";
  std::vector<geo::LonLat> places;
  for (std::size_t row = part.first; row <= part.last; ++row) places.push_back(plan.waypoints[row].place);
  return goto_list_text(comments, once, list.radius, initial, places);
}

std::string hold_list_text(const planning::Plan& plan, const List& list, const std::string& head,
                           const GotoListOptions& options) {
  const HoldLegs& hold = *list.hold;
  const planning::Waypoint& place = plan.waypoints[list.part.last];
  const std::string comments =
      head + print("hold at waypoint %zu of %zu\n", list.part.last, plan.waypoints.size() - 1) +
      hold_comment({place.eta, place.eta + place.wait}) +
      (hold.legs < 0
           ? "# goes round until the next list is sent\n"
           : print("# %d legs, expected to take %.1f h from the arrival to the departure,\n"
                   "# with 6 minutes at the surface at its begin, its end%s\n",
                   hold.legs, hold.expected.count() / 3600.0,
                   hold_flight(plan, list.part.last, options.holds).surfaces ? " and every turn" : "")) +
      origin_comments(plan, options.origin);
  return goto_list_text(comments, hold.legs, list.radius, 0, hold_rows(place.place, hold));
}

}  // namespace

core::Metres default_waypoint_radius(const planning::Plan& plan) {
  const std::vector<core::Metres> legs = leg_lengths(plan);
  const double shortest_m = std::min_element(legs.begin(), legs.end())->value;
  return {std::clamp(std::ceil(shortest_m / 2.0) - 1.0, smallest_radius_m, largest_default_radius_m)};
}

core::Seconds longest_list_time(const planning::Plan& plan, const GotoListOptions& options) {
  core::Seconds longest{0.0};
  for (const ListPart& part : part_into_lists(plan, rules_of(options)))
    longest = std::max(longest, time_of(plan, part));
  return longest;
}

tl::expected<MissionFiles, core::Violations> write_goto_lists(const planning::Plan& plan,
                                                              const GotoListOptions& options) {
  if (core::Violations found = violations_of_options(plan, options); !found.empty())
    return tl::unexpected(std::move(found));
  const std::vector<List> lists = lists_of_plan(plan, options);
  if (core::Violations found = violations_of_numbers(lists, options); !found.empty())
    return tl::unexpected(std::move(found));
  const std::vector<core::Metres> legs = leg_lengths(plan);

  MissionFiles written;
  int initial = options.initial_waypoint;  // for the first list with waypoints
  for (std::size_t i = 0; i < lists.size(); ++i) {
    const List& list = lists[i];
    const std::string head = print("# %s, list %zu of %zu: ", list.file_name.c_str(), i + 1, lists.size());
    if (list.hold) {
      written.files.push_back({list.file_name, hold_list_text(plan, list, head, options)});
    } else {
      written.files.push_back({list.file_name, list_text(plan, list, head, initial, options)});
      initial = 0;
    }
  }
  written.messages = messages_for(plan, options, legs, lists);
  return written;
}

}  // namespace floeplan::mission

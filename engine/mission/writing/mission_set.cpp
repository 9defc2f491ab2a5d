#include "engine/mission/writing/mission_set.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/core/letter_case.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/mission/document/line_words.hpp"
#include "engine/mission/document/thruster_yo.hpp"
#include "engine/mission/writing/argument_lines.hpp"
#include "engine/mission/writing/below_ice.hpp"
#include "engine/mission/writing/flight_files.hpp"
#include "engine/mission/writing/ice_files.hpp"
#include "engine/mission/writing/list_parts.hpp"

namespace floeplan::mission {
namespace {

constexpr Firmware oldest{7, 0};  // older documents describe other behaviors
constexpr Firmware newest{11, 99};
constexpr double room_for_detours = 1.5;  // ratio of max_wpt_distance to the longest leg

/// Whether the name is one of the missions that are on every vehicle. A plan must not replace them.
/// Source   the vendor's release 10.5, missions of the 200 m and 1000 m vehicles
bool is_stock_mission(const std::string& name) {
  static constexpr const char* stock[] = {
      "astock",  "autoexec", "bathtub",  "breadcr",  "clrabort", "freewig",  "hold",    "ice",
      "ini0",    "ini_ice",  "initial",  "lastgasp", "loadsim",  "nocop",    "nofly",   "recov",
      "sci_off", "sci_on",   "setpitch", "status",   "stock",    "thrstock", "waterclr"};
  return std::ranges::find(stock, name) != std::end(stock);
}

core::Violations violations_of(const planning::Plan& plan, const MissionSetOptions& options) {
  core::Violations found = ice_violations(plan, options);
  const std::string& name = options.name;
  if (!is_name(name) || name.size() > 8 || name != core::lower_case(name))
    found.push_back(messages::mission_fault<"wrong-mission-name">("/mission"));
  if (is_stock_mission(name)) found.push_back(messages::mission_fault<"mission-on-board">("/mission", name));
  if (options.firmware < oldest || newest < options.firmware)
    found.push_back(messages::mission_fault<"wrong-firmware">("/firmware"));
  const int last = surfacings_of(plan, options).back().number;
  if (options.lists.first_number < 0 || last > last_free_number) {
    found.push_back(messages::mission_fault<"file-numbers-used-up">("/number", last));
  }
  return found;
}

/// The largest position error at a fix at the end of a list.
core::Metres largest_error(const planning::Plan& plan, const GotoListOptions& options) {
  core::Metres largest{0.0};
  const ListRules rules{.max_waypoints = static_cast<std::size_t>(options.max_waypoints),
                        .between_fixes = options.between_fixes};
  for (const ListPart& part : part_into_lists(plan, rules)) largest = std::max(largest, error_of(plan, part));
  return largest;
}

/// Largest distance of a waypoint, in metres, at which the vehicle does not abort. After a fix the waypoint
/// may be farther away by the position error; twice the expected error is allowed for.
double max_waypoint_distance_m(const planning::Plan& plan, const GotoListOptions& options) {
  double longest_m = 0.0;
  for (const planning::Waypoint& waypoint : plan.waypoints) {
    if (waypoint.leg_length) longest_m = std::max(longest_m, waypoint.leg_length->value);
  }
  const double error_m = 2.0 * largest_error(plan, options).value;
  return 1000.0 * std::ceil((room_for_detours * longest_m + error_m) / 1000.0);
}

std::string behavior_from_file(const char* behavior, int number) {
  return std::string{"\nbehavior: "} + behavior + "\n" +
         argument_lines(behavior, {{"args_from_file", whole(number)}});
}

std::string mission_text(const planning::Plan& plan, const MissionSetOptions& options) {
  const int number = options.lists.first_number;
  std::string text = "# " + options.name + ".mi for firmware " + std::to_string(options.firmware.major) +
                     "." + std::to_string(options.firmware.minor) + "\n" +
                     origin_comments(plan, options.lists.origin) +
                     "\nsensor: u_use_current_correction(nodim) 1\n"
                     "sensor: c_science_all_on_enabled(bool) 1\n";
  if (options.under_ice) text += ice_settings(plan, options);
  text +=
      "\nbehavior: abend\n" +
      argument_lines(
          "abend", {{"overdepth", whole(overdepth(options.vehicle).value)},
                    {"overtime", "-1"},
                    {"samedepth_for", "1800"},
                    {"stalled_for", "1800"},
                    {"no_cop_tickle_for", "48600"},
                    {"max_wpt_distance", whole(max_waypoint_distance_m(plan, list_options(plan, options)))}});
  for (const Surfacing& surfacing : surfacings_of(plan, options)) {
    text += "\n# Comes up when " + surfacing.why + ".";
    text += behavior_from_file("surface", surfacing.number);
  }
  text += behavior_from_file("goto_list", number);
  text += behavior_from_file("yo", number);
  text += behavior_from_file("sample", number);
  text += behavior_from_file("prepare_to_dive", number);
  return text + "\nbehavior: sensors_in\n";
}

/// Violations that make the mission unsafe below ice.
core::Violations violations_below_ice(const planning::Plan& plan, const MissionSetOptions& options) {
  core::Violations found;
  if (!tells_upper_turns(plan)) {
    found.push_back(messages::mission_fault<"turns-of-earlier-version">("/plan_id"));
  }
  if (least_upper_turn(plan).value > 0.0 && !options.under_ice) {
    found.push_back(messages::mission_fault<"safe-places-required">("/under_ice"));
  }
  return found;
}

/// Whether the ice or icebergs above the plan determine the yo's upper turn.
bool is_below_ice(const planning::Plan& plan, const vehicle::GliderProfile& vehicle) {
  return climb_target(plan, vehicle).value <= std::ceil(least_upper_turn(plan).value);
}

std::string climb_text(const planning::Plan& plan, const vehicle::GliderProfile& vehicle) {
  return whole(climb_target(plan, vehicle).value) +
         (is_below_ice(plan, vehicle) ? " m because of ice or icebergs" : " m");
}

/// Violations at shoals: the yo turns at the same two depths on the whole route.
core::Violations violations_of_yo(const planning::Plan& plan, const MissionSetOptions& options) {
  core::Violations found;
  const vehicle::GliderProfile& vehicle = options.vehicle;
  const core::Metres least_dive = climb_target(plan, vehicle) + vehicle::lowest_tooth;
  if (least_dive > target_depth(vehicle)) {
    found.push_back(messages::mission_fault<"no-room-for-yo">("/dive_depth_m", target_depth(vehicle).value,
                                                              climb_text(plan, vehicle)));
  }
  const core::Metres needed = least_dive + core::Metres{std::ceil(vehicle.altimeter_margin.value)};
  const auto shoal = shoalest_of(plan, options.shoals);
  if (!shoal || shoal->bed >= needed) return found;
  const auto too_shallow = [&]<messages::Code code>() {
    return messages::mission_fault<code>("/waypoints", std::floor(shoal->bed.value), place_text(shoal->place),
                                         shoal->waypoint, climb_text(plan, vehicle), needed.value);
  };
  found.push_back(is_below_ice(plan, vehicle) ? too_shallow.operator()<"water-too-shallow-for-yo-below-ice">()
                                              : too_shallow.operator()<"water-too-shallow-for-yo">());
  return found;
}

/// Whether the depth of the sea bed is known at some place of each leg.
bool knows_bed(const planning::Plan& plan, const MissionSetOptions& options) {
  return options.shoals.size() == plan.waypoints.size() &&
         std::all_of(options.shoals.begin() + 1, options.shoals.end(),
                     [](const std::optional<Shoal>& shoal) { return shoal.has_value(); });
}

}  // namespace

tl::expected<MissionFiles, core::Violations> write_mission_set(const planning::Plan& plan,
                                                               const MissionSetOptions& options) {
  core::Violations found = violations_of(plan, options);
  std::ranges::move(violations_below_ice(plan, options), std::back_inserter(found));
  std::ranges::move(violations_of_yo(plan, options), std::back_inserter(found));
  GotoListOptions of_lists = list_options(plan, options);
  of_lists.thruster_in_yo = thruster_of_yo(plan, options.vehicle).has_value();
  auto lists = write_goto_lists(plan, of_lists);
  if (!lists) std::ranges::copy(lists.error(), std::back_inserter(found));
  if (!found.empty()) return tl::unexpected(std::move(found));

  MissionFiles set;
  set.files.push_back({options.name + ".mi", mission_text(plan, options)});
  std::ranges::move(lists->files, std::back_inserter(set.files));
  std::ranges::move(flight_files(plan, options), std::back_inserter(set.files));
  set.messages = std::move(lists->messages);
  const vehicle::GliderProfile& vehicle = options.vehicle;
  if (target_depth(vehicle) < core::Metres{std::floor(vehicle.dive_depth.value)}) {
    set.messages.push_back(messages::export_message<"yo-above-plan">(
        target_depth(vehicle).value, vehicle.dive_depth.value, vehicle.depth_rating.value));
  }
  set.messages.push_back(of_lists.thruster_in_yo ? messages::export_message<"pump-and-thruster-of-profile">()
                                                 : messages::export_message<"pump-of-profile">());
  if (options.under_ice) {
    std::ranges::move(ice_files(plan, options), std::back_inserter(set.files));
    std::ranges::move(ice_warnings(plan, options), std::back_inserter(set.messages));
    if (!knows_bed(plan, options))
      set.messages.push_back(messages::export_message<"bed-unknown-below-ice">());
  }
  return set;
}

}  // namespace floeplan::mission

#include "engine/mission/document/list_rules.hpp"

#include <algorithm>
#include <cmath>

#include "engine/messages/mission_file_messages.hpp"
#include "engine/mission/document/argument_rules.hpp"
#include "engine/mission/document/flown_rows.hpp"
#include "engine/mission/document/setting_line.hpp"

namespace floeplan::mission {
namespace {

constexpr double smallest_radius_m = 10.0;  // minimum of list_when_wpt_dist in the vehicle's data dictionary
constexpr double by_longitude_and_latitude = 2.0;  // wpt_units

bool is_whole(double value) { return value == std::floor(value); }
bool is_parameter(const Argument* argument) {
  return argument != nullptr && is_mission_parameter(argument->value);
}

void check_radius(const Behavior& list, Messages& messages) {
  const Argument* radius = list.find("list_when_wpt_dist");
  if (radius == nullptr) {
    messages.push_back(finding(list.line, messages::mission_file_message<"list_when_wpt_dist_not_given">()));
  } else if (radius->value < smallest_radius_m) {
    messages.push_back(finding(radius->line, messages::mission_file_message<"radius_below_minimum">()));
  }
}

void check_legs(const Behavior& list, Messages& messages) {
  const Argument* legs = list.find("num_legs_to_run");
  if (legs == nullptr || is_parameter(legs)) return;
  if (legs->value == 0.0 || legs->value < -2.0 || legs->value > most_legs || !is_whole(legs->value)) {
    messages.push_back(finding(legs->line, messages::mission_file_message<"illegal_legs">(most_legs)));
  }
}

/// Checks initial_wpt. `rows`: number of rows; empty: unknown.
void check_initial(const Behavior& list, std::optional<std::size_t> rows, Messages& messages) {
  const Argument* initial = list.find("initial_wpt");
  if (initial == nullptr || is_parameter(initial)) return;
  const bool beyond = rows && initial->value >= 0.0 && initial->value >= static_cast<double>(*rows);
  if (!is_whole(initial->value) || initial->value < -2.0 || beyond) {
    messages.push_back(finding(initial->line, messages::mission_file_message<"bad_initial_wpt">()));
  }
}

void check_count(const Behavior& list, std::size_t rows, Messages& messages) {
  const Argument* declared = list.find("num_waypoints");
  if (declared == nullptr) {
    messages.push_back(finding(list.line, messages::mission_file_message<"num_waypoints_not_given">(rows)));
    return;
  }
  const std::string& count = declared->raw;
  if (!is_whole(declared->value) || declared->value < 1.0) {
    messages.push_back(finding(
        declared->line, messages::mission_file_message<"waypoint_count_mismatch/no-count">(count, rows)));
  } else if (declared->value > static_cast<double>(rows)) {
    messages.push_back(
        finding(declared->line, messages::mission_file_message<"waypoint_count_mismatch">(count, rows)));
  } else if (declared->value < static_cast<double>(rows)) {
    messages.push_back(finding(declared->line,
                               messages::mission_file_message<"waypoint_count_mismatch/fewer">(count, rows)));
  }
}

std::size_t digits_before_point(const std::string& raw) {
  const std::size_t first = raw.find_first_of("0123456789.");
  if (first == std::string::npos) return 0;
  const std::size_t end = std::min(raw.find_first_not_of("0123456789", first), raw.size());
  return end - first;
}

}  // namespace

void check_decimal_look(const std::vector<WaypointRow>& rows, Messages& messages) {
  const bool decimal = !rows.empty() && std::ranges::all_of(rows, [](const WaypointRow& row) {
    return digits_before_point(row.lon_raw) <= 3 && digits_before_point(row.lat_raw) <= 2;
  });
  if (!decimal) return;
  messages.push_back(finding(rows.front().line, messages::mission_file_message<"decimal_degrees">()));
}

void check_list(const Behavior& list, const std::vector<WaypointRow>& rows, Messages& messages) {
  check_count(list, rows.size(), messages);
  check_radius(list, messages);
  check_legs(list, messages);
  check_initial(list, rows.size(), messages);
  check_decimal_look(rows, messages);
}

void check_inline_list(const Behavior& list, Messages& messages) {
  check_legs(list, messages);
  const Argument* file = list.find("args_from_file");
  const bool from_file = file != nullptr && file->value >= 0.0;
  if (from_file) return check_initial(list, std::nullopt, messages);

  std::size_t slots = 0;
  while (list.find("wpt_x_" + std::to_string(slots)) != nullptr) ++slots;
  check_count(list, slots, messages);
  check_radius(list, messages);
  check_initial(list, slots, messages);
}

std::vector<WaypointRow> inline_waypoints(const Behavior& behavior, Messages& messages) {
  std::vector<WaypointRow> rows;
  const bool list = behavior.name == "goto_list";
  for (int slot = 0; slot < 100; ++slot) {
    const std::string ending = list ? "_" + std::to_string(slot) : "";
    const Argument* x = behavior.find("wpt_x" + ending);
    const Argument* y = behavior.find("wpt_y" + ending);
    if (x == nullptr || y == nullptr) break;
    const Argument* units = behavior.find("wpt_units" + ending);
    if (units == nullptr || units->value != by_longitude_and_latitude) {
      messages.push_back(finding(x->line, messages::mission_file_message<"local_coordinates">()));
    } else if (!is_parameter(x) && !is_parameter(y)) {
      rows.push_back({x->raw, y->raw, read_packed_place(x->value, y->value, x->line, messages), x->line});
    }
    if (!list) break;
  }
  return rows;
}

}  // namespace floeplan::mission

#include "engine/mission/document/behavior_table.hpp"

#include <algorithm>

namespace floeplan::mission {
namespace {

constexpr std::optional<double> open{};

constexpr ArgumentRule abend[] = {
    {"overdepth", "m", 10000},
    {"overdepth_sample_time", "sec", 15},
    {"overtime", "sec", -1},
    {"undervolts", "volts", 10},
    {"undervolts_sample_time", "sec", 60},
    {"samedepth_for", "sec", 1800},
    {"samedepth_for_sample_time", "sec", 30},
    {"stalled_for", "sec", 1800},
    {"stalled_for_sample_time", "sec", 1800},
    {"no_cop_tickle_for", "sec", 48600},
    {"no_cop_tickle_percent", "%", -1},
    {"no_comms_tickle_for", "hours", 72},
    {"max_wpt_distance", "m", -1},
    {"chk_sensor_reasonableness", "bool", 1},
    {"reqd_free_heap", "bytes", 50000},
    {"reqd_spare_heap", "bytes"},
    {"leakdetect_sample_time", "sec", 60},
    {"vacuum_min", "inHg", 4},
    {"vacuum_max", "inHg", 12},
    {"vacuum_sample_time", "sec", 120},
    {"oil_volume_sample_time", "sec", 180},
    {"max_allowable_busy_cpu_cycles", "cycles", 75},
    {"remaining_charge_min", "%", 10},
    {"remaining_charge_sample_time", "sec", 60},
    {"use_thruster_for_ascent", "bool", 0},
    {"invalid_gps", "nodim", 10},
    {"check_emergency_battery_active", "bool", 0},
    {"samedepth_for_surfacing", "sec", 900},
    {"eng_pressure_mul", "nodim", 0.9},
    {"eng_pressure_sample_time", "sec", 15},
};

constexpr ArgumentRule surface[] = {
    {"args_from_file", "enum", -1},
    {"start_when", "enum", 12},
    {"when_secs", "sec", 1200},
    {"when_wpt_dist", "m", 10},
    {"when_num_inflections", "nodim", -1},
    {"end_action", "enum", 1, 0, 5},
    {"report_all", "bool", 0},
    {"gps_wait_time", "sec", 300},
    {"keystroke_wait_time", "sec", 300, 0, 900},
    {"end_wpt_dist", "m", 0},
    {"c_use_bpump", "enum", 2},
    {"c_bpump_value", "X", 1000},
    {"c_use_pitch", "enum", 3},
    {"c_pitch_value", "X", 0.4538},
    {"c_stop_when_air_pump", "bool", 0},
    {"c_use_thruster", "enum", 0, 0, 5},
    {"c_thruster_value", "X", 0},
    {"printout_cycle_time", "sec", 60},
    {"gps_postfix_wait_time", "sec", 60},
    {"force_iridium_use", "nodim", 0},
    {"min_time_between_gps_fixes", "sec", 300},
    {"sensor_input_wait_time", "sec", 10},
    {"when_utc_timestamp", "dtime", -1},
    {"when_utc_on_surface", "bool", 0},
    {"when_utc_month", "month"},
    {"when_utc_day", "day"},
    {"when_utc_hour", "hour"},
    {"when_utc_min", "min"},
    {"strobe_on", "bool", 0},
    {"thruster_burst", "bool", 0},
};

constexpr ArgumentRule goto_list[] = {
    {"args_from_file", "enum", -1},
    {"start_when", "enum", 0},
    {"num_waypoints", "nodim", 0},
    {"num_legs_to_run", "nodim", -1, -2},
    {"initial_wpt", "enum", -2, -2},
    {"list_stop_when", "enum", 7},
    {"list_when_wpt_dist", "m", 10, 10},
    {"end_action", "enum", 0, 0, 6},
    {"primary_wpt", "bool", 0, 0, 1},
    {"primary_stop_when", "enum", 15},
    {"primary_when_wpt_dist", "m", 10},
    {"wpt_units_0", "enum", 0, 0, 2},
    {"wpt_x_0", "X", 0},
    {"wpt_y_0", "X", 0},
    {"wpt_units_1", "enum", 0, 0, 2},
    {"wpt_x_1", "X", 0},
    {"wpt_y_1", "X", 0},
    {"wpt_units_2", "enum", 0, 0, 2},
    {"wpt_x_2", "X", 0},
    {"wpt_y_2", "X", 0},
    {"wpt_units_3", "enum", 0, 0, 2},
    {"wpt_x_3", "X", 0},
    {"wpt_y_3", "X", 0},
    {"wpt_units_4", "enum", 0, 0, 2},
    {"wpt_x_4", "X", 0},
    {"wpt_y_4", "X", 0},
    {"wpt_units_5", "enum", 0, 0, 2},
    {"wpt_x_5", "X", 0},
    {"wpt_y_5", "X", 0},
    {"wpt_units_6", "enum", 0, 0, 2},
    {"wpt_x_6", "X", 0},
    {"wpt_y_6", "X", 0},
    {"wpt_units_7", "enum", 0, 0, 2},
    {"wpt_x_7", "X", 0},
    {"wpt_y_7", "X", 0},
};

constexpr ArgumentRule goto_wpt[] = {
    {"start_when", "enum", 0}, {"stop_when", "enum", 2},       {"when_secs", "sec"},
    {"when_wpt_dist", "m", 0}, {"wpt_units", "enum", 0, 0, 2}, {"wpt_x", "X", 0},
    {"wpt_y", "X", 0},         {"utm_zd", "byte", 19},         {"utm_zc", "byte", 19},
    {"end_action", "enum", 0},
};

constexpr ArgumentRule yo[] = {
    {"args_from_file", "enum", -1},
    {"start_when", "enum", 2},
    {"start_diving", "enum", 1, 0, 2},
    {"num_half_cycles_to_do", "nodim", -1},
    {"end_action", "enum", 2, 0, 2},
    {"stop_when", "enum", 5},
    {"when_secs", "sec", 1200},
    {"when_wpt_dist", "m", 10},
    {"d_target_depth", "m", 12, 3, 1000},
    {"d_target_altitude", "m", 5, open, 100},
    {"d_use_bpump", "enum", 2, 0, 5},
    {"d_bpump_value", "X", -260},
    {"d_use_pitch", "enum", 3, 1, 4},
    {"d_pitch_value", "X", -0.4538},
    {"d_stop_when_hover_for", "sec", 180},
    {"d_stop_when_stalled_for", "sec", 240},
    {"d_speed_min", "m/s", -100},
    {"d_speed_max", "m/s", 100},
    {"d_use_thruster", "enum", 0, 0, 5},
    {"d_thruster_value", "X", 0},
    {"d_depth_rate_method", "enum", 3},
    {"d_wait_for_pitch", "bool", 1},
    {"d_wait_for_ballast", "sec", 100},
    {"d_delta_bpump_speed", "X", 50},
    {"d_delta_bpump_ballast", "X", 25},
    {"d_time_ratio", "X", 1.1},
    {"d_use_sc_model", "bool", 0},
    {"d_max_thermal_charge_time", "sec", 1200},
    {"d_max_pumping_charge_time", "sec", 300},
    {"d_thr_reqd_pres_mul", "nodim", 1.5},
    {"c_target_depth", "m", 3, 3, 1000},
    {"c_target_altitude", "m", -1, open, 100},
    {"c_use_bpump", "enum", 2, 0, 5},
    {"c_bpump_value", "X", 260},
    {"c_use_pitch", "enum", 3, 1, 4},
    {"c_pitch_value", "X", 0.4538},
    {"c_stop_when_hover_for", "sec", 180},
    {"c_stop_when_stalled_for", "sec", 240},
    {"c_speed_min", "m/s", 100},
    {"c_speed_max", "m/s", -100},
    {"c_use_thruster", "enum", 0, 0, 5},
    {"c_thruster_value", "X", 0},
};

// The arguments of dive_to and climb_to are called as in a yo, but without the prefix.
constexpr ArgumentRule dive_to[] = {
    {"target_depth", "m"},
    {"target_altitude", "m"},
    {"use_bpump", "enum"},
    {"bpump_value", "X"},
    {"use_pitch", "enum"},
    {"pitch_value", "X"},
    {"start_when", "enum", 0},
    {"stop_when_hover_for", "sec"},
    {"stop_when_stalled_for", "sec"},
    {"speed_min", "m/s"},
    {"speed_max", "m/s"},
    {"use_thruster", "enum", open, 0, 5},
    {"thruster_value", "X"},
    {"stop_when_air_pump", "bool", 0},
    {"initial_inflection", "bool", 1},
};

constexpr ArgumentRule set_heading[] = {
    {"args_from_file", "enum", -1}, {"use_heading", "bool", 2}, {"heading_value", "X", 1000},
    {"start_when", "enum", 0},      {"stop_when", "enum", 5},   {"when_secs", "sec", 1200},
    {"when_wpt_dist", "m"},         {"end_action", "enum", 0},
};

constexpr ArgumentRule drift_at_depth[] = {
    {"args_from_file", "enum"},
    {"start_when", "enum"},
    {"when_secs", "sec", 180},
    {"end_action", "enum"},
    {"target_depth", "m", 100},
    {"target_altitude", "m", 20},
    {"target_deadband", "m", 5},
    {"stop_when_hover_for", "sec", 3600},
    {"est_time_to_settle", "s", 360},
    {"start_dist_from_target", "m"},
    {"alt_time", "s"},
    {"depth_ctrl", "enum", 0, 0, 2},
    {"enable_steering", "bool", 0},
    {"bpump_delay", "s"},
    {"bpump_delta_value", "cc"},
    {"bpump_deadz_width", "cc"},
    {"bpump_db_frac_dz", "nodim"},
    {"use_pitch", "enum"},
    {"pitch_value", "X"},
    {"wait_for_pitch", "bool"},
    {"use_thruster", "enum", open, 0, 5},
    {"thruster_value", "X"},
    {"d_use_bpump", "enum"},
    {"d_bpump_value", "X"},
    {"d_use_pitch", "enum"},
    {"d_pitch_value", "X"},
    {"c_use_bpump", "enum"},
    {"c_bpump_value", "X"},
    {"c_use_pitch", "enum"},
    {"c_pitch_value", "X"},
};

constexpr ArgumentRule sample[] = {
    {"args_from_file", "enum", -1},
    {"sensor_type", "enum", 0},
    {"state_to_sample", "enum", 1, 0, 15},
    {"sample_time_after_state_change", "s", 15},
    {"intersample_time", "s", 0},
    {"nth_yo_to_sample", "nodim", 1},
    {"intersample_depth", "m", -1},
    {"min_depth", "m", -5},
    {"max_depth", "m", 2000},
    {"tod_start", "hhmm"},  // newer than firmware 10.5
    {"tod_stop", "hhmm"},
};

constexpr ArgumentRule prepare_to_dive[] = {
    {"args_from_file", "enum", -1},
    {"start_when", "enum", 0},
    {"wait_time", "sec", 720},
    {"max_thermal_charge_time", "sec", 120},
    {"max_pumping_charge_time", "sec", 1000},
};

constexpr BehaviorRule behaviors[] = {
    {"abend", abend},
    {"surface", surface},
    {"goto_list", goto_list},
    {"goto_wpt", goto_wpt},
    {"yo", yo},
    {"dive_to", dive_to},
    {"climb_to", dive_to},
    {"set_heading", set_heading},
    {"drift_at_depth", drift_at_depth, false},
    {"sample", sample},
    {"prepare_to_dive", prepare_to_dive},
    {"sensors_in", {}, false},
    {"nop_cmds", {}, false},
};

}  // namespace

const ArgumentRule* BehaviorRule::find(std::string_view argument) const {
  const auto found = std::ranges::find(arguments, argument, &ArgumentRule::name);
  return found == arguments.end() ? nullptr : &*found;
}

const BehaviorRule* find_behavior(std::string_view name) {
  const auto* found = std::ranges::find(behaviors, name, &BehaviorRule::name);
  return found == std::ranges::end(behaviors) ? nullptr : found;
}

const BehaviorRule* sole_owner(std::string_view argument) {
  const BehaviorRule* owner = nullptr;
  for (const BehaviorRule& behavior : behaviors) {
    if (behavior.find(argument) == nullptr) continue;
    if (owner != nullptr) return nullptr;
    owner = &behavior;
  }
  return owner;
}

std::string_view file_prefix(std::string_view behavior) { return behavior.substr(0, 6); }

const BehaviorRule* find_by_file_prefix(std::string_view prefix) {
  const auto* found = std::ranges::find_if(
      behaviors, [&](const BehaviorRule& behavior) { return file_prefix(behavior.name) == prefix; });
  return found == std::ranges::end(behaviors) ? nullptr : found;
}

}  // namespace floeplan::mission

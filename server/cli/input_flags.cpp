#include "server/cli/input_flags.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "api/codec/json_text.hpp"
#include "server/cli/command.hpp"
#include "server/cli/flag_values.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

json place_of(const std::string& flag, const std::string& text) {
  const auto place = parse_place(text);
  if (!place)
    throw CLI::ValidationError{flag, text + " is not LON,LAT in degrees; as " + flag + "=-53.2,69.2"};
  return json::array({place->lon_deg, place->lat_deg});
}

/// Sets a member of an object that is a member of the inputs; what a request file has there that is none stays, to be
/// refused with the rest of the inputs.
void set_inside(json& inputs, const char* object, const char* key, json value) {
  json& stated = inputs[object];
  if (stated.is_null() || stated.is_object()) stated[key] = std::move(value);
}

/// "mean", or the share that a quantile is of.
void set_robust(json& inputs, const std::string& text) {
  const auto numbers = parse_numbers(text);
  if (text != "mean" && (!numbers || numbers->size() != 1)) {
    throw CLI::ValidationError{"--robust", text + " is neither mean nor a share such as 0.9"};
  }
  set_inside(inputs, "uncertainty", "objective", numbers ? "quantile" : "mean");
  if (numbers) set_inside(inputs, "uncertainty", "quantile", numbers->front());
}

/// "time", "energy" or "weighted:W"; another word goes on, to be refused with the rest of the inputs.
json objective_of(const std::string& text) {
  const std::string weighted = "weighted:";
  if (!text.starts_with(weighted)) return text;
  const auto weight = parse_numbers(text.substr(weighted.size()));
  if (!weight || weight->size() != 1) {
    throw CLI::ValidationError{"--objective", text + " has no weight; as weighted:0.5"};
  }
  return {{"time", 1.0}, {"energy", weight->front()}};
}

/// Sixteen times what the server takes by default: a longer text takes seconds to read before its content is refused.
constexpr std::size_t most_bytes = 16UL * 1024 * 1024;

}  // namespace

json read_object(const std::string& file, const std::string& what) {
  const std::string subject = "the " + what + " " + file;
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw std::runtime_error{subject + " cannot be read; check its name"};
  std::string text(most_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > most_bytes)
    throw BadDataError{subject +
                       " is longer than 16 MB; store areas with ingest, or leave out what is far away"};
  json object;
  try {
    object = json::parse(text);
  } catch (const json::out_of_range&) {
    throw BadDataError{subject + " holds a number that is too large; give finite numbers"};
  } catch (const json::parse_error& error) {
    throw BadDataError{subject + " is not JSON from byte " + std::to_string(error.byte) +
                       " on; check brackets, commas and quotes there"};
  }
  // The parser takes what the server refuses: one key twice, and nesting without an end.
  if (const auto checked = codec::parse_json(text); !checked)
    throw BadDataError{subject + " is refused. " + checked.error()};
  if (!object.is_object()) throw BadDataError{subject + " is not a JSON object"};
  return object;
}

json file_member(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  std::string text{std::istreambuf_iterator<char>{stream}, {}};
  if (!stream && text.empty())
    throw std::runtime_error{"the file " + file + " cannot be read; check its name"};
  return {{"name", std::filesystem::path{file}.filename().string()}, {"text", std::move(text)}};
}

void InputFlags::add_voyage(CLI::App& command) {
  command.add_option("--depart", depart_, "Departure, ISO 8601 with zone, as 2026-11-20T06:00:00Z");
  command.add_option(
      "--vehicle", vehicle_,
      "Vehicle profile; default slocum-g3-200. One of your own: the object \"vehicle\" of --request");
  command.add_option("--speed", speed_m_s_, "Horizontal speed through water, m/s");
  command.add_option("--pitch", pitch_deg_,
                     "Of dives and climbs, degrees; without --speed it gives the speed of the steady glide");
  command.add_option("--climb-to", climb_to_m_, "Top of the saw-tooth, metres");
  command.add_option("--dive-depth", dive_depth_m_, "Bottom of the saw-tooth in deep water, metres");
  command.add_option("--altimeter-margin", altimeter_margin_m_, "Kept above the sea bed, metres");
  command.add_option("--battery", battery_j_, "Energy of the full battery, joules");
  command.add_option("--battery-start", battery_start_share_, "Share of it at the departure, 0 to 1");
  command.add_option("--currents", currents_,
                     "ID[,ID...] or none; default: the newest that cover area and departure");
  command.add_flag("--steady", steady_, "Use the one time step, or the mean of all, for every time");
  command.add_option("--tides", tides_, "Tidal currents, ID[,ID...], newest or none; default: none");
  command.add_option("--tides-mode", tides_mode_,
                     "add: to currents that are without tides; only: tidal currents alone");
  command.add_option("--bathymetry", bathymetry_,
                     "ID[,ID...] in order of priority, or none; default: all of the area, the finest first");
  command.add_option(
      "--ice", ice_,
      "Sea ice, ID or none; default: the newest of the time, older ones where it tells nothing");
  command.add_option("--icebergs", icebergs_,
                     "ID[,ID...] or none; default: the newest, and those made by hand beside it");
  command.add_option("--icebergs-as-of", icebergs_as_of_, "Latest sighting to use; default: the departure");
  command.add_option("--coastline", coastline_, "ID or none; default: the newest");
  command.add_option(
      "--wind", wind_,
      "Wind that moves icebergs, ID or none; default: the newest that covers area and departure");
  command.add_option("--zones", zones_,
                     "Stored zones to obey, ID[,ID...] or none; default: all that meet the area");
  command.add_option("--margin", margin_m_, "Kept from icebergs, metres; default 500");
  command.add_option("--areas", areas_file_, "GeoJSON file of areas to keep out of or to stay in");
  command.add_flag("--no-iceberg-drift", no_iceberg_drift_, "Take icebergs to stay where they were seen");
  command.add_option("--max-inflation", max_inflation_m_,
                     "Kept from icebergs for the error of their positions, metres at most; default 5000");
  command.add_option("--max-sighting-age", max_sighting_age_days_,
                     "Leave out icebergs last seen longer before the departure, days; default 3");
  command.add_flag("--pass-under", pass_under_,
                   "Pass under icebergs of known size whose keels end well above the dives' depth");
  command.add_option("--keel-clearance", keel_clearance_m_,
                     "Kept below the deepest keel when passing under, metres; default 20");
  command.add_option("--draft-uncertainty", draft_uncertainty_,
                     "Share added to every iceberg's draft when passing under, 0 to 2; default 0.25");
  command.add_option("--name", name_, "Name of the plan");
}

void InputFlags::add_passing_under_ice(CLI::App& command) {
  command.add_option("--max-concentration-to-surface", max_concentration_to_surface_,
                     "Share of ice, 0 to 1, up to which the vehicle may surface; default 0.1");
  command.add_option("--margin-below-ice", margin_below_ice_m_,
                     "Kept between the deepest keel and the upper turn of the dives, metres; default 10");
  command
      .add_option(
          "--max-time-without-surfacing", max_time_without_surfacing_s_,
          "Longest time between places where the vehicle may surface, seconds or as PT10H; default: any")
      ->transform(seconds_or_duration());
}

void InputFlags::add_route_rules(CLI::App& command) {
  command.add_option("--objective", objective_,
                     "time (default), energy, or weighted:W with W the seconds that a joule is worth");
  command.add_option("--thruster", thruster_, "auto (default: as the objective has it), on or off");
  command.add_flag("--require-battery", require_battery_, "No plan beyond what the battery gives");
  command
      .add_option(
          "--max-loiter", max_loiter_s_,
          "Let the vehicle wait at a waypoint for what clears later, icebergs, timed areas or currents, at "
          "most so many seconds, or as PT2H; default 0")
      ->transform(seconds_or_duration());
  add_passing_under_ice(command);
  command
      .add_option("--surfacing-interval", surfacing_interval_s_,
                  "Plan a surfacing about this often, seconds or as PT6H; default: none")
      ->transform(seconds_or_duration());
  command.add_flag("--escape-plan", escape_plan_,
                   "Find from every waypoint the way to where the vehicle may surface");
}

void InputFlags::set_under_ice(json& inputs) const {
  json rules = json::object();
  if (max_concentration_to_surface_) rules["max_concentration_to_surface"] = *max_concentration_to_surface_;
  if (margin_below_ice_m_) rules["margin_below_ice_m"] = *margin_below_ice_m_;
  if (max_time_without_surfacing_s_) rules["max_time_without_surfacing_s"] = *max_time_without_surfacing_s_;
  if (surfacing_interval_s_) rules["surfacing_interval_s"] = *surfacing_interval_s_;
  if (escape_plan_) rules["escape_plan"] = true;
  if (rules.empty()) return;
  json& stated = inputs["under_ice"];
  if (stated.is_null()) stated = json::object();
  if (stated.is_object()) stated.update(rules);
}

void InputFlags::add_request(CLI::App& command, const std::string& inputs) {
  command.add_option("--request", request_file_, "JSON file with " + inputs);
}

void InputFlags::add_start(CLI::App& command) {
  command.add_option("--from", from_, "Where a route from a mission file starts, LON,LAT in degrees");
}

void InputFlags::add_route_name(CLI::App& command) {
  command.add_option("--route", route_name_,
                     "Name or number of the route to take from a file that holds several");
}

void InputFlags::add_planning(CLI::App& command) {
  command.add_option("--encounter-weight", encounter_weight_s_,
                     "Seconds of travel that one expected encounter with an iceberg counts as; default 0");
  command.add_option("--from", from_, "Start, LON,LAT in degrees");
  command.add_option("--to", to_, "Goal, LON,LAT in degrees");
  command.add_option("--via", via_, "Place to visit on the way; may be repeated, in order")
      ->allow_extra_args(false);
  command.add_option(
      "--goals", goals_file_,
      "File with the places to visit instead of --via and --to: .ma, .mi, GPX, KML, GeoJSON, CSV, NMEA, "
      "Seaglider targets or an IMC plan; without --from its first place is the start");
  add_route_name(command);
  command.add_option("--members", members_,
                     "Draw this many errors of the currents (2 to 64) and show the spread");
  command.add_option("--current-error", current_error_m_s_,
                     "Standard deviation of each component's error, m/s");
  command.add_option("--error-length", error_length_m_, "Over how far the error is alike, metres");
  command.add_option("--error-time", error_time_s_, "Over how long the error is alike, seconds or as PT12H")
      ->transform(seconds_or_duration());
  command.add_option("--robust", robust_,
                     "Make the best of all members: mean, or a share such as 0.9 that is to arrive early");
  command.add_option("--arrive-before", arrive_before_, "Show the chance to be there by then");
  command.add_flag("--best-order", best_order_, "Visit the places of --via in the order that ends earliest");
  command.add_option("--depart-until", depart_until_,
                     "Last departure of a window that starts at --depart; the best one is planned");
  command.add_option("--depart-step", depart_step_,
                     "From one departure of the window to the next, as PT1H (the default)");
  command.add_option("--arrive-by", arrive_by_,
                     "Leave as late as this arrival allows; --depart is then the earliest departure");
  command.add_option("--spacing", spacing_m_,
                     "Grid step M, or M,M along and across; default distance/200, 250 m to 5 km; searches by "
                     "energy or weights begin with 2.5 times as much");
  command.add_option("--sectors", sectors_, "Reach of the grid's edges, 1 to 5; default 3");
  command.add_option("--method", method_, "tve, dijkstra, astar, frozen or direct; default astar");
  command.add_option("--max-waypoints", max_waypoints_, "Start and goal included");
  command.add_option("--max-leg", max_leg_m_, "Longest leg, metres; longer ones are parted");
  command.add_option("--refine-seconds", refine_seconds_,
                     "Computing time for moving waypoints off the grid, 0.05 to 60; default 1");
  command.add_flag("--no-refine", no_refine_, "Leave the way as the grid gave it");
  command.add_flag("--no-optimality-gap", no_optimality_gap_,
                   "Do not compare the plan with the best way in open water");
}

void InputFlags::add_reach(CLI::App& command) {
  command.add_option("--from", from_, "Where the vehicle leaves at --depart, LON,LAT in degrees");
  command.add_option("--to", to_, "Where it is to be at --arrive-by, LON,LAT in degrees");
  command.add_option("--arrive-by", arrive_by_, "Latest arrival at --to, ISO 8601 with zone");
  command.add_option("--hours", hours_, "Hours after the departure, or before the arrival, as 6,12,24");
  command.add_option("--spacing", spacing_m_,
                     "Grid step, metres; default a hundredth of the way in still water, 100 m to 5 km");
  command.add_option(
      "--sectors", sectors_,
      "Reach of the grid's edges, 1 to 5; default 3, and 5 where currents are as fast as the vehicle");
  add_passing_under_ice(command);
}

json InputFlags::inputs() const {
  json inputs = request_file_ ? read_object(*request_file_, "request file") : json::object();
  const auto set = [&](const char* key, const auto& flag) {
    if (flag) inputs[key] = *flag;
    // JSON has no number for it, and the inputs would speak of null.
    if constexpr (std::is_same_v<decltype(flag), const std::optional<double>&>) {
      if (flag && !std::isfinite(*flag)) inputs[key] = "a number that is not finite";
    }
  };
  if (from_) inputs["from"] = place_of("--from", *from_);
  if (to_) inputs["to"] = place_of("--to", *to_);
  set("route_name", route_name_);
  if (goals_file_) inputs["goals_file"] = file_member(*goals_file_);
  if (!via_.empty()) {
    inputs["via"] = json::array();
    for (const std::string& via : via_) inputs["via"].push_back(place_of("--via", via));
  }
  if (spacing_m_) {
    const auto numbers = parse_numbers(*spacing_m_);
    if (!numbers || numbers->size() > 2) {
      throw CLI::ValidationError{"--spacing", *spacing_m_ + " is not metres; as 1000 or 1000,500"};
    }
    inputs["spacing_m"] = numbers->size() == 1 ? json((*numbers)[0]) : json(*numbers);
  }
  if (hours_) {
    const auto numbers = parse_numbers(*hours_);
    if (!numbers) throw CLI::ValidationError{"--hours", *hours_ + " is not hours; as 6 or 6,12,24"};
    inputs["hours"] = *numbers;
  }
  const auto set_ids = [&](const char* key, const std::optional<std::string>& flag) {
    if (!flag) return;
    const auto ids = split_at_commas(*flag);
    inputs[key] = ids.size() == 1 ? json(ids.front()) : json(ids);
  };
  set_ids("currents", currents_);
  set_ids("tides", tides_);
  set("wind", wind_);
  set_ids("zones", zones_);
  set("tides_mode", tides_mode_);
  if (areas_file_) inputs["areas"] = read_object(*areas_file_, "file of areas");
  set("depart", depart_);
  set("depart_until", depart_until_);
  set("depart_step", depart_step_);
  set("arrive_by", arrive_by_);
  set("vehicle", vehicle_);
  set("speed_m_s", speed_m_s_);
  set("pitch_deg", pitch_deg_);
  set("climb_to_m", climb_to_m_);
  set("dive_depth_m", dive_depth_m_);
  set("altimeter_margin_m", altimeter_margin_m_);
  set("battery_j", battery_j_);
  set("battery_start_share", battery_start_share_);
  set("sectors", sectors_);
  set("method", method_);
  if (objective_) inputs["objective"] = objective_of(*objective_);
  set("thruster", thruster_);
  if (require_battery_) inputs["require_battery"] = true;
  set("max_waypoints", max_waypoints_);
  set("max_leg_m", max_leg_m_);
  set("refine_seconds", refine_seconds_);
  set_ids("bathymetry", bathymetry_);
  set("ice", ice_);
  set_ids("icebergs", icebergs_);
  set("icebergs_as_of", icebergs_as_of_);
  set("coastline", coastline_);
  set("margin_m", margin_m_);
  set("max_inflation_m", max_inflation_m_);
  set("max_sighting_age_days", max_sighting_age_days_);
  set("max_loiter_s", max_loiter_s_);
  set("encounter_weight_s", encounter_weight_s_);
  if (pass_under_) inputs["pass_under_icebergs"] = true;
  set("keel_clearance_m", keel_clearance_m_);
  set("draft_uncertainty", draft_uncertainty_);
  set("name", name_);
  if (members_) set_inside(inputs, "uncertainty", "members", *members_);
  if (current_error_m_s_) set_inside(inputs, "uncertainty", "current_error_m_s", *current_error_m_s_);
  if (error_length_m_) set_inside(inputs, "uncertainty", "length_scale_m", *error_length_m_);
  if (error_time_s_) set_inside(inputs, "uncertainty", "time_scale_s", *error_time_s_);
  if (arrive_before_) set_inside(inputs, "uncertainty", "arrive_before", *arrive_before_);
  if (robust_) set_robust(inputs, *robust_);
  if (best_order_) inputs["via_order"] = "best";
  set_under_ice(inputs);
  if (steady_) inputs["steady"] = true;
  if (no_iceberg_drift_) inputs["icebergs_drift"] = false;
  if (no_refine_) inputs["refine"] = false;
  if (no_optimality_gap_) inputs["optimality_gap"] = false;
  return inputs;
}

}  // namespace floeplan::cli

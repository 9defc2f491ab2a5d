#include "engine/mission/writing/flight_files.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/mission/document/thruster_yo.hpp"
#include "engine/mission/writing/argument_lines.hpp"
#include "engine/mission/writing/below_ice.hpp"

namespace floeplan::mission {
namespace {

// Codes of start_when in the vendor's data dictionary of firmware 10.5.
constexpr std::string_view start_when_pitch_idle = "2";
constexpr std::string_view start_when_heading_idle = "3";
constexpr std::string_view start_when_waypoint_hit = "8";
constexpr std::string_view start_when_every = "9";
constexpr std::string_view start_when_silent = "12";

// A glider dives deeper than its target before it turns, and aborts at its overdepth. Operators of shallow
// vehicles set the overdepth 10 to 15 % below the target. Those of 1000 m vehicles dive to 980 m (missions of
// the Southwest Fisheries Science Center).
constexpr double overshoot_of_shallow = 1.10;
constexpr double deep_share_of_rating = 0.98;
constexpr double usual_overdepth = 1.15;
/// A turn takes some metres at every depth. With the slow oil pump of a deep vehicle it takes as many as its
/// altitude allows.
constexpr double least_overshoot_shallow_m = 3.0;
constexpr double least_overshoot_deep_m = 20.0;
constexpr double shallow_vehicle_m = 350.0;
constexpr double silence_shallow_s =
    10'800.0;  // between the 20 minutes of the stock mission and the 8 hours of operators
constexpr double silence_deep_s = 28'800.0;     // 1000 m missions of operators
constexpr double regular_shallow_s = 10'800.0;  // stock missions
constexpr double regular_deep_s = 21'600.0;     // longest in 1000 m missions of operators
constexpr double round_depth_m = 10.0;  // a target from 100 m on is a multiple of this, as operators write it
constexpr double least_climb_m = 3.0;   // minimum of c_target_depth in the same dictionary
constexpr double silence_under_ice_share = 1.25;

struct SurfacingKind {
  std::string_view why;
  std::string_view start_when;
  std::string_view end_action;  // 0: ends the mission; 1: waits for the pilot, then continues
};

constexpr SurfacingKind silent{"no contact for too long", start_when_silent, "1"};
constexpr SurfacingKind list_done{"the list is flown", start_when_heading_idle, "0"};
constexpr SurfacingKind yo_done{"the yo has ended", start_when_pitch_idle, "1"};
constexpr SurfacingKind waypoint_hit{"a waypoint is reached", start_when_waypoint_hit, "1"};
constexpr SurfacingKind regular{"the time between surfacings has passed", start_when_every, "1"};

bool is_shallow(const vehicle::GliderProfile& vehicle) {
  return vehicle.depth_rating.value <= shallow_vehicle_m;
}

std::vector<SurfacingKind> kinds_of(const planning::Plan& plan, const MissionSetOptions& options) {
  std::vector<SurfacingKind> kinds{silent, list_done, yo_done};
  if (surfaces_on_the_way(plan, options)) kinds.insert(kinds.end(), {waypoint_hit, regular});
  return kinds;
}

MissionFile file(std::string_view behavior, int number, const std::string& what, const std::string& origin,
                 const std::vector<ArgumentValue>& values) {
  const std::string name = argument_file_name(behavior, number);
  return {name, argument_file(behavior, "# " + name + ": " + what + "\n" + origin, values)};
}

MissionFile surfacing_file(const planning::Plan& plan, const MissionSetOptions& options, int number,
                           const SurfacingKind& kind, const std::string& origin) {
  std::vector<ArgumentValue> values{{"start_when", std::string{kind.start_when}}};
  if (kind.start_when == start_when_silent)
    values.push_back({"when_secs", whole(longest_silence(plan, options).count())});
  if (kind.start_when == start_when_every)
    values.push_back({"when_secs", whole(time_between_surfacings(options).count())});
  values.push_back({"end_action", std::string{kind.end_action}});
  values.push_back({"gps_wait_time", "300"});
  values.push_back({"keystroke_wait_time", "300"});
  return file("surface", number, "comes up when " + std::string{kind.why}, origin, values);
}

MissionFile yo_file(const planning::Plan& plan, const MissionSetOptions& options, int number,
                    const std::string& origin) {
  const auto& vehicle = options.vehicle;
  const std::string pitch_rad = decimal(vehicle.pitch.value, 4);
  const std::string pump_cc = whole(vehicle.buoyancy.value * 1e6);
  std::vector<ArgumentValue> values{
      {"start_when", std::string{start_when_pitch_idle}},
      {"num_half_cycles_to_do", "-1"},
      {"d_target_depth", whole(target_depth(vehicle).value)},
      {"d_target_altitude", whole(std::ceil(vehicle.altimeter_margin.value))},
      {"d_use_bpump", "2"},  // absolute, in cm3
      {"d_bpump_value", "-" + pump_cc},
      {"d_use_pitch", "3"},  // held by the battery's servo; radians, nose down is negative
      {"d_pitch_value", "-" + pitch_rad},
      {"c_target_depth", whole(climb_target(plan, vehicle).value)},
      {"c_use_bpump", "2"},
      {"c_bpump_value", pump_cc},
      {"c_use_pitch", "3"},
      {"c_pitch_value", pitch_rad},
      {"end_action", "2"}};
  if (const auto power = thruster_of_yo(plan, vehicle)) {
    for (const std::string_view argument : {"d_use_thruster", "c_use_thruster"})
      values.push_back({argument, whole(thruster_by_power)});
    for (const std::string_view argument : {"d_thruster_value", "c_thruster_value"})
      values.push_back({argument, decimal(power->value, 2)});
  }
  return file("yo", number, "dives and climbs until the list is flown", origin, values);
}

}  // namespace

core::Metres target_depth(const vehicle::GliderProfile& vehicle) {
  const double rating_m = vehicle.depth_rating.value;
  double lowest_m = is_shallow(vehicle)
                        ? std::min(rating_m / overshoot_of_shallow, rating_m - least_overshoot_shallow_m)
                        : std::min(deep_share_of_rating * rating_m, rating_m - least_overshoot_deep_m);
  if (lowest_m >= 10.0 * round_depth_m) lowest_m = round_depth_m * std::floor(lowest_m / round_depth_m);
  return {std::floor(std::min(vehicle.dive_depth.value, lowest_m))};
}

core::Metres overdepth(const vehicle::GliderProfile& vehicle) {
  const double target_m = target_depth(vehicle).value;
  const double least_m = is_shallow(vehicle) ? least_overshoot_shallow_m : least_overshoot_deep_m;
  return {std::min(vehicle.depth_rating.value,
                   std::ceil(std::max(usual_overdepth * target_m, target_m + least_m)))};
}

core::Metres climb_target(const planning::Plan& plan, const vehicle::GliderProfile& vehicle) {
  return {std::max({least_climb_m, vehicle.climb_to.value, std::ceil(least_upper_turn(plan).value)})};
}

core::Seconds longest_silence(const planning::Plan& plan, const MissionSetOptions& options) {
  const double in_the_open_s = is_shallow(options.vehicle) ? silence_shallow_s : silence_deep_s;
  if (surfaces_on_the_way(plan, options)) {
    const core::Seconds usual{in_the_open_s};
    return std::min(usual, options.surfacing_interval.value_or(usual));
  }
  // Under ice no contact is possible on the route, and several lists may be flown without contact. So the
  // time is whole hours above the plan's duration.
  const double planned_s = silence_under_ice_share * plan.travel_time().count();
  return core::Seconds{std::max(in_the_open_s, 3600.0 * std::ceil(planned_s / 3600.0))};
}

core::Seconds usual_surfacing_interval(const vehicle::GliderProfile& vehicle) {
  return core::Seconds{is_shallow(vehicle) ? regular_shallow_s : regular_deep_s};
}

core::Seconds time_between_surfacings(const MissionSetOptions& options) {
  return options.surfacing_interval.value_or(usual_surfacing_interval(options.vehicle));
}

bool surfaces_on_the_way(const planning::Plan& plan, const MissionSetOptions& options) {
  return !options.under_ice || may_surface_everywhere(plan);
}

GotoListOptions list_options(const planning::Plan& plan, const MissionSetOptions& options) {
  GotoListOptions lists = options.lists;
  lists.holds.vehicle = options.vehicle;
  lists.holds.surfaces = surfaces_on_the_way(plan, options);
  lists.holds.between_surfacings = time_between_surfacings(options);
  if (may_surface_everywhere(plan)) lists.between_fixes = time_between_surfacings(options);
  return lists;
}

std::vector<Surfacing> surfacings_of(const planning::Plan& plan, const MissionSetOptions& options) {
  std::vector<Surfacing> surfacings;
  for (const SurfacingKind& kind : kinds_of(plan, options)) {
    const int number = options.lists.first_number + static_cast<int>(surfacings.size());
    surfacings.push_back({number, std::string{kind.why}});
  }
  return surfacings;
}

std::vector<MissionFile> flight_files(const planning::Plan& plan, const MissionSetOptions& options) {
  const int number = options.lists.first_number;
  const std::string origin = origin_comments(plan, options.lists.origin);
  std::vector<MissionFile> files{yo_file(plan, options, number, origin)};
  const auto kinds = kinds_of(plan, options);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    files.push_back(surfacing_file(plan, options, number + static_cast<int>(i), kinds[i], origin));
  }
  files.push_back(file("sample", number, "all science sensors while diving", origin,
                       {{"sensor_type", "0"}, {"state_to_sample", "1"}, {"intersample_time", "0"}}));
  files.push_back(file("prepare_to_dive", number, "waits for a fix before the first dive", origin,
                       {{"start_when", "0"}, {"wait_time", "720"}}));
  return files;
}

}  // namespace floeplan::mission

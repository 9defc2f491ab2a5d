#include "engine/planning/diagnosis/input_changes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>
#include <span>
#include <utility>

#include "engine/core/utc_text.hpp"
#include "engine/geo/geodesic.hpp"

namespace floeplan::planning::diagnosis {
namespace {

constexpr std::size_t most_zones = 10;  // zones that are left out one at a time, at most
constexpr core::Seconds an_hour = InputTrials::an_hour;
constexpr core::Seconds a_day{86'400.0};
constexpr core::Seconds two_days{172'800.0};  // latest departure that is tried

std::string written(const char* format, double from, double to) {
  char text[120];
  std::snprintf(text, sizeof text, format, from, to);
  return text;
}

}  // namespace

core::MetresPerSecond fastest_tried(core::MetresPerSecond now) {
  constexpr core::MetresPerSecond fastest{5.0};  // limit of the request
  return std::min(fastest, 8.0 * now);
}

template <class Set>
std::optional<double> InputChanges::nearest(double now, double extreme, double unit, const Set& set) {
  return trials_.nearest_that_helps(now, extreme, unit, [&](double value) {
    PlanRequest changed = request_;
    set(changed, value);
    return changed;
  });
}

void InputChanges::raise_speed() {
  const double now = request_.vehicle.speed_through_water.value;
  const auto needed = nearest(now, fastest_tried({now}).value, 0.01, [](PlanRequest& changed, double speed) {
    changed.vehicle.speed_through_water = {speed};
  });
  if (!needed) return;
  add("speed_m_s", now, *needed, *needed / now,
      written("raise the speed through the water from %.2f to %.2f m/s", now, *needed));
}

void InputChanges::raise_the_thrusters_speed() {
  if (drives(request_.energy, request_.vehicle).back() != vehicle::Drive::thruster) return;
  const double now = request_.vehicle.thruster->speed.value;
  const auto needed = nearest(now, fastest_tried({now}).value, 0.01, [](PlanRequest& changed, double speed) {
    changed.vehicle.thruster = vehicle::Thruster{.speed = {speed}, .power = vehicle::thruster_power({speed})};
  });
  if (!needed) return;
  add("vehicle/thruster/speed_m_s", now, *needed, *needed / now,
      written("raise the thruster's speed from %.2f to %.2f m/s", now, *needed));
}

bool InputChanges::helps_to_use_it(ThrusterUse use) {
  trials_.begin_input();
  PlanRequest changed = request_;
  changed.energy.thruster = use;
  return !trials_.is_over() && trials_.works(changed);
}

void InputChanges::use_the_thruster() {
  const ThrusterUse now = request_.energy.thruster;
  if (!request_.vehicle.thruster || now != ThrusterUse::off) return;
  if (!helps_to_use_it(ThrusterUse::automatic)) return;
  add("thruster", thruster_use_name(now), thruster_use_name(ThrusterUse::automatic), 1.5,
      "let the vehicle use its thruster");
}

void InputChanges::leave_the_thruster_off() {
  const ThrusterUse now = request_.energy.thruster;
  if (!request_.vehicle.thruster || now == ThrusterUse::off) return;
  if (!helps_to_use_it(ThrusterUse::off)) return;
  add("thruster", thruster_use_name(now), thruster_use_name(ThrusterUse::off), 2.0, "leave the thruster off");
}

void InputChanges::shrink_margin() {
  const double now = request_.icebergs.margin.value;
  const auto needed = nearest(
      now, 0.0, 10.0, [](PlanRequest& changed, double margin) { changed.icebergs.margin = {margin}; });
  if (!needed) return;
  add("margin_m", now, *needed, 2.0 - *needed / now,
      written("reduce the margin around icebergs from %.0f to %.0f m", now, *needed));
}

void InputChanges::allow_for_less_error() {
  if (!request_.icebergs.drift) return;
  const double now = request_.icebergs.max_inflation.value;
  const auto needed = nearest(
      now, 0.0, 100.0, [](PlanRequest& changed, double error) { changed.icebergs.max_inflation = {error}; });
  if (!needed) return;
  add("max_inflation_m", now, *needed, 2.0 - *needed / now,
      written("reduce the position allowance of icebergs from %.0f to %.0f m", now, *needed));
}

void InputChanges::stay_longer_under_ice() {
  if (!request_.under_ice.max_time_without_surfacing) return;
  const double now = request_.under_ice.max_time_without_surfacing->count();
  const double longest = std::max(8.0 * now, two_days.count());
  const auto needed = nearest(now, longest, 600.0, [](PlanRequest& changed, double time_s) {
    changed.under_ice.max_time_without_surfacing = core::Seconds{time_s};
  });
  if (!needed) return;
  add("under_ice/max_time_without_surfacing_s", now, *needed, *needed / now,
      "allow " + core::hours_minutes(core::Seconds{*needed}) + " without a place to surface instead of " +
          core::hours_minutes(core::Seconds{now}));
}

void InputChanges::keep_less_from_ice() {
  const double now = request_.under_ice.margin_below_ice.value;
  const auto needed = nearest(now, 0.0, 1.0, [](PlanRequest& changed, double margin) {
    changed.under_ice.margin_below_ice = {margin};
  });
  if (!needed) return;
  add("under_ice/margin_below_ice_m", now, *needed, 2.0 - *needed / now,
      written("reduce the clearance below ice from %.0f to %.0f m", now, *needed));
}

void InputChanges::dive_towards(double extreme) {
  const double now = request_.vehicle.dive_depth.value;
  const auto needed = nearest(
      now, extreme, 1.0, [](PlanRequest& changed, double depth) { changed.vehicle.dive_depth = {depth}; });
  if (!needed) return;
  add("dive_depth_m", now, *needed, *needed > now ? *needed / now : 2.0 - *needed / now,
      written("dive to %.0f m instead of %.0f m", *needed, now));
}

void InputChanges::dive_deeper() { dive_towards(request_.vehicle.depth_rating.value); }

void InputChanges::dive_less_deep() {
  const double least_m = std::ceil(request_.vehicle.climb_to.value + vehicle::lowest_tooth.value);
  std::set<double, std::greater<>> above_tops_m;
  bool has_depths = false;
  for (const auto* zones : {&request_.zones, &environment_.zones}) {
    for (const ocean::Zone& zone : *zones) {
      has_depths = has_depths || zone.top.value > 0.0 || std::isfinite(zone.bottom.value);
      const double above_m = std::ceil(zone.top.value) - 1.0;
      if (above_m >= least_m && above_m < request_.vehicle.dive_depth.value) above_tops_m.insert(above_m);
    }
  }
  if (!has_depths) return;
  // Depths just above a zone come first: the shallowest dives may take too much energy, or the current may be too
  // strong there.
  std::size_t tried = 0;
  for (const double above_m : above_tops_m) {
    if (++tried > most_zones) break;
    trials_.begin_input();
    PlanRequest changed = request_;
    changed.vehicle.dive_depth = {above_m};
    if (trials_.is_over()) return;
    if (trials_.works(changed)) return dive_towards(above_m);
  }
  dive_towards(least_m);
}

double InputChanges::standard_margin_m() const {
  const auto profile = vehicle::find_profile(request_.vehicle.name);
  return profile ? profile->altimeter_margin.value : request_.vehicle.altimeter_margin.value;
}

void InputChanges::keep_less_above_the_bed() {
  const double now = request_.vehicle.altimeter_margin.value;
  const double usual = standard_margin_m();
  if (now <= usual) return;
  const auto needed = nearest(now, usual, 1.0, [](PlanRequest& changed, double margin) {
    changed.vehicle.altimeter_margin = {margin};
  });
  if (!needed) return;
  add("altimeter_margin_m", now, *needed, 2.0 - *needed / now,
      written("keep %.0f m above the sea bed instead of %.0f m", *needed, now));
}

void InputChanges::work_in_shallower_water() {
  const double now = request_.vehicle.minimum_working_depth.value;
  const auto profile = vehicle::find_profile(request_.vehicle.name);
  if (!profile || now <= profile->minimum_working_depth.value) return;
  const auto needed =
      nearest(now, profile->minimum_working_depth.value, 1.0,
              [](PlanRequest& changed, double depth) { changed.vehicle.minimum_working_depth = {depth}; });
  if (!needed) return;
  add("vehicle/minimum_working_depth_m", now, *needed, 2.0 - *needed / now,
      written("let the vehicle work in water of %.0f m instead of %.0f m", *needed, now));
}

void InputChanges::climb_higher() {
  const double now = request_.vehicle.climb_to.value;
  const auto profile = vehicle::find_profile(request_.vehicle.name);
  if (!profile || now <= profile->climb_to.value) return;
  const auto needed = nearest(now, profile->climb_to.value, 1.0,
                              [](PlanRequest& changed, double depth) { changed.vehicle.climb_to = {depth}; });
  if (!needed) return;
  add("climb_to_m", now, *needed, 2.0 - *needed / now,
      written("climb to %.0f m on each dive instead of %.0f m", *needed, now));
}

void InputChanges::take_another_vehicle() {
  if (!vehicle::is_known_but_for_choices(request_.vehicle)) return;
  const vehicle::FlightChoices& flight = request_.flight;
  trials_.begin_input();
  for (const vehicle::GliderProfile& profile : vehicle::profiles_for_shallower_water(request_.vehicle.name)) {
    PlanRequest changed = request_;
    changed.vehicle = vehicle::with_choices(profile, flight);
    if (flight.pitch && !flight.speed_through_water)
      changed.vehicle = vehicle::at_speed_of_glide(std::move(changed.vehicle));
    if (trials_.is_over()) return;
    if (changed.vehicle.least_water() >= request_.vehicle.least_water() || !trials_.works(changed)) continue;
    add("vehicle", request_.vehicle.name, profile.name, 4.0,
        "take the vehicle " + profile.name +
            written(", which works in water of %.0f m, instead of one for %.0f m",
                    changed.vehicle.least_water().value, request_.vehicle.least_water().value));
    return;
  }
}

void InputChanges::charge_the_battery() {
  const double now = request_.vehicle.energy.battery_start_share;
  const auto needed = nearest(now, 1.0, 0.01, [](PlanRequest& changed, double share) {
    changed.vehicle.energy.battery_start_share = share;
  });
  if (!needed) return;
  add("battery_start_share", now, *needed, *needed / now,
      written("start with %.3g %% of the battery's charge instead of %.3g %%", 100.0 * *needed, 100.0 * now));
}

void InputChanges::take_a_larger_battery() {
  const double now = request_.vehicle.energy.battery.value;
  const double three_digits = std::pow(10.0, std::floor(std::log10(now)) - 2.0);
  const auto needed = nearest(now, 8.0 * now, three_digits, [](PlanRequest& changed, double battery_j) {
    changed.vehicle.energy.battery = {battery_j};
  });
  if (!needed) return;
  add("battery_j", now, *needed, 1.0 + *needed / now,
      written("take a battery of %.4g MJ instead of %.4g MJ", *needed / 1e6, now / 1e6));
}

void InputChanges::leave_out_zones() {
  if (!leave_out_a_zone()) leave_out_all_zones();
}

bool InputChanges::leave_out_a_zone() {
  trials_.begin_input();
  bool any_helps = false;
  const std::span<const ocean::Zone> zones{request_.zones};
  std::size_t parts = 0;
  for (std::size_t first = 0, number = 0; first < zones.size() && number < most_zones;
       first += parts, ++number) {
    parts = ocean::parts_of_first(zones.subspan(first));
    PlanRequest changed = request_;
    const auto left_out = changed.zones.begin() + static_cast<std::ptrdiff_t>(first);
    changed.zones.erase(left_out, left_out + static_cast<std::ptrdiff_t>(parts));
    if (trials_.is_over()) break;
    if (!trials_.works(changed)) continue;
    any_helps = true;
    const std::string& name = zones[first].name;
    add("areas/features/" + std::to_string(zones[first].feature.value_or(number)), name, std::string{}, 2.0,
        "leave out the area " + (name.empty() ? "number " + std::to_string(number + 1) : "\"" + name + "\""));
  }
  return any_helps;
}

void InputChanges::leave_out_all_zones() {
  std::size_t areas = 0;
  for (std::span<const ocean::Zone> left{request_.zones}; !left.empty(); ++areas)
    left = left.subspan(ocean::parts_of_first(left));
  if (areas < 2) return;
  trials_.begin_input();
  PlanRequest changed = request_;
  changed.zones.clear();
  if (trials_.is_over() || !trials_.works(changed)) return;
  const std::string all = std::to_string(areas) + " areas";
  add("areas", all, Change::Nothing{}, 3.0, "leave out all " + all);
}

void InputChanges::leave_out_stored_zones(const Trial& without) {
  trials_.begin_input();
  if (environment_.zones.empty() || !without || trials_.is_over()) return;
  if (!trials_.works_by(without, request_)) return;
  const std::string& name = environment_.zones.front().name;
  const std::string more = environment_.zones.size() > 1
                               ? " and " + std::to_string(environment_.zones.size() - 1) + " more"
                               : std::string{};
  add("zones", name + more, std::string{"none"}, 3.0, "leave out the stored areas: \"" + name + "\"" + more);
  found_.back().changed.reset();
}

void InputChanges::refine_the_grid() {
  if (!request_.spacing_along) return;
  const double now = request_.spacing_along->value;
  for (const double share : {0.5, 0.25}) {
    // A request with few but very long steps may take less work on a finer grid that covers a smaller area.
    trials_.begin_input();
    PlanRequest changed = request_;
    changed.spacing_along = core::Metres{share * now};
    if (request_.spacing_across)
      changed.spacing_across = core::Metres{share * request_.spacing_across->value};
    if (trials_.is_over() || !changed.violations().empty()) return;
    if (!trials_.works(changed)) continue;
    if (request_.spacing_across) {
      const double across = request_.spacing_across->value;
      add("spacing_m", std::array{now, across}, std::array{share * now, share * across}, 1.0 / share,
          written("search on a grid of %.0f by %.0f m", share * now, share * across) +
              written(" instead of %.0f by %.0f m", now, across));
      return;
    }
    add("spacing_m", now, share * now, 1.0 / share,
        written("search on a grid of %.0f m instead of %.0f m", share * now, now));
    return;
  }
}

PlanRequest InputChanges::leaving(double hours_later) const {
  PlanRequest changed = request_;
  changed.depart = request_.depart + hours_later * an_hour;
  return changed;
}

double InputChanges::least_delay(double fails, double helps) {
  while (helps - fails > 1.0 && !trials_.is_over()) {
    const double middle = std::floor(0.5 * (fails + helps));
    (trials_.works(leaving(middle)) ? helps : fails) = middle;
  }
  return helps;
}

void InputChanges::add_departure(double hours) {
  const core::UtcTime later = request_.depart + hours * an_hour;
  add("depart", request_.depart, later, 1.0 + hours / 24.0,
      "depart " + written("%.0f h later, at ", hours, 0.0) + core::iso8601(later));
  found_.back().changed = leaving(hours);
}

void InputChanges::depart_later() {
  trials_.begin_input();
  const bool currents_change = environment_.currents && !environment_.steady_currents;
  if (!currents_change && environment_.icebergs.empty()) return;
  const double end_s = currents_change ? environment_.currents->times_s().back() : INFINITY;
  double too_early = 0.0;
  for (const double hours : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 9.0, 12.0, 18.0, 24.0, 48.0}) {
    const core::UtcTime later = request_.depart + hours * an_hour;
    if (trials_.is_over() || core::unix_seconds(later) >= end_s) return;
    if (!trials_.works(leaving(hours))) {
      too_early = hours;
      continue;
    }
    add_departure(least_delay(too_early, hours));
    return;
  }
  return;
}

void InputChanges::depart_after(core::Seconds delay) {
  trials_.begin_input();
  const double whole_hours = std::ceil(delay / an_hour);
  double too_early = whole_hours - 1.0;
  // Later departures are tried, too, because icebergs and ice move on.
  for (const double more : {0.0, 2.0, 5.0, 12.0}) {
    const double hours = whole_hours + more;
    if (trials_.is_over()) return;
    if (trials_.works(leaving(hours))) {
      add_departure(least_delay(too_early, hours));
      return;
    }
    too_early = hours;
  }
}

void InputChanges::allow_holds() {
  const core::Seconds now = request_.holds.longest;
  if (now >= longest_hold_allowed) return;
  trials_.begin_input();
  PlanRequest changed = request_;
  changed.holds.longest = longest_hold_allowed;
  if (trials_.is_over() || !trials_.works(changed)) return;
  add("max_loiter_s", now.count(), longest_hold_allowed.count(), 1.0,
      now.count() > 0.0 ? written("allow holds of any length instead of %.4g h at most", now / an_hour, 0.0)
                        : std::string{"allow holds"});
}

void InputChanges::take_move(const Change& move) {
  const double way_m = std::max(1.0, geo::geodesic_between(request_.from, request_.to).length.value);
  const double moved_m =
      geo::geodesic_between(std::get<geo::LonLat>(move.from), std::get<geo::LonLat>(move.to)).length.value;
  found_.push_back({move, 1.0 + moved_m / way_m});
}

void InputChanges::add(std::string input, Change::Value from, Change::Value to, double effort,
                       std::string text) {
  found_.push_back(
      {{std::move(input), std::move(from), std::move(to), std::move(text)}, effort, trials_.last_possible()});
}

FoundChanges InputChanges::found() && {
  std::ranges::stable_sort(found_, {}, &Found::effort);
  FoundChanges result{.changes = {}, .cut_short = trials_.told_too_little()};
  if (!found_.empty()) result.changed = std::move(found_.front().changed);
  for (Found& found : found_) result.changes.push_back(std::move(found.change));
  return result;
}

}  // namespace floeplan::planning::diagnosis

#include "engine/vehicle/glider_profile.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace floeplan::vehicle {
namespace {

/// "slocum-g3-thruster" of "slocum-g3-200-thruster".
std::string name_but_for_depth(const GliderProfile& profile) {
  const std::string rating = "-" + std::to_string(std::lround(profile.depth_rating.value));
  std::string name = profile.name;
  if (const auto at = name.find(rating); at != std::string::npos) name.erase(at, rating.size());
  return name;
}

}  // namespace

core::Violations GliderProfile::violations() const {
  core::Violations found;
  const auto require = [&](bool holds, const char* field, const char* rule) {
    if (!holds) found.push_back({field, rule});
  };
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  require(within(speed_through_water.value, 0.05, 5.0), "/speed_m_s", "must be between 0.05 and 5 m/s");
  const double pitch_deg = core::radians_to_degrees(pitch.value);
  require(within(pitch_deg, least_pitch_deg - 1e-9, most_pitch_deg + 1e-9) &&
              glide_path_angle(hydrodynamics, pitch).has_value(),
          "/pitch_deg", "must be between 10 and 60 degrees, steep enough for a steady glide");
  require(within(buoyancy.value, 1e-5, 1e-2), "/vehicle/buoyancy_cm3", "must be between 10 and 10000 cm3");
  require(within(depth_rating.value, 2.0, 11'000.0), "/vehicle/depth_rating_m",
          "must be between 2 and 11000 m");
  require(dive_depth.value >= 1.0 && dive_depth.value <= depth_rating.value, "/dive_depth_m",
          "must be at least 1 m and no deeper than the vehicle's rating");
  require(climb_to.value >= 0.0, "/climb_to_m", "must not be negative");
  require(!(dive_depth.value < climb_to.value + lowest_tooth.value), "/climb_to_m",
          "must be at least 2 m above the depth of the dives");
  require(within(minimum_working_depth.value, 0.0, 11'000.0), "/vehicle/minimum_working_depth_m",
          "must be between 0 and 11000 m");
  require(within(altimeter_margin.value, 0.0, 1000.0), "/altimeter_margin_m", "must be between 0 and 1000 m");
  require(within(energy.hotel.value, 0.0, 1000.0), "/vehicle/hotel_w", "must be between 0 and 1000 W");
  require(within(energy.pump_efficiency, 0.01, 1.0), "/vehicle/pump_efficiency",
          "must be between 0.01 and 1");
  require(within(energy.pump_loss_j_cm3, 0.0, 1000.0), "/vehicle/pump_loss_j_cm3",
          "must be between 0 and 1000 J/cm3");
  require(within(energy.intake_j_cm3, 0.0, 1000.0), "/vehicle/intake_j_cm3",
          "must be between 0 and 1000 J/cm3");
  require(within(energy.inflection.value, 0.0, 1e6), "/vehicle/inflection_j", "must be between 0 and 1e6 J");
  require(within(energy.surfacing.value, 0.0, 1e7), "/vehicle/surfacing_j", "must be between 0 and 1e7 J");
  require(!energy.surfacing_interval || within(energy.surfacing_interval->count(), 60.0, 1e7),
          "/vehicle/surfacing_interval_s", "must be between 60 and 1e7 s");
  require(within(energy.battery.value, 1.0, 1e10), "/battery_j", "must be between 1 and 1e10 J");
  require(within(energy.battery_start_share, 0.0, 1.0), "/battery_start_share", "must be between 0 and 1");
  require(within(energy.battery_reserve_share, 0.0, 1.0), "/vehicle/battery_reserve_share",
          "must be between 0 and 1");
  require(!thruster || within(thruster->speed.value, 0.05, 5.0), "/vehicle/thruster/speed_m_s",
          "must be between 0.05 and 5 m/s");
  require(!thruster || within(thruster->power.value, 0.0, 10'000.0), "/vehicle/thruster/power_w",
          "must be between 0 and 10000 W");
  require(max_waypoints_per_list >= 1, "/vehicle/max_waypoints_per_list", "must be at least 1");
  return found;
}

core::Metres GliderProfile::least_water() const {
  return std::max(minimum_working_depth, climb_to + lowest_tooth + altimeter_margin);
}

core::Metres GliderProfile::least_water_below_turn() const {
  return std::max(minimum_working_depth, lowest_tooth + altimeter_margin);
}

core::MetresPerSecond GliderProfile::vertical_speed(core::MetresPerSecond horizontal) const {
  return {horizontal.value * std::tan(glide_path_angle(hydrodynamics, pitch).value().value)};
}

std::optional<GliderProfile> find_profile(std::string_view name) {
  const auto found = std::ranges::find(known_profiles(), name, &GliderProfile::name);
  if (found == known_profiles().end()) return std::nullopt;
  return *found;
}

std::vector<GliderProfile> profiles_for_shallower_water(std::string_view name) {
  const auto profile = find_profile(name);
  if (!profile) return {};
  std::vector<GliderProfile> shallower;
  for (const GliderProfile& other : known_profiles()) {
    if (name_but_for_depth(other) == name_but_for_depth(*profile) &&
        other.least_water() < profile->least_water())
      shallower.push_back(other);
  }
  std::ranges::sort(shallower, std::greater{}, &GliderProfile::least_water);
  return shallower;
}

}  // namespace floeplan::vehicle

#include "engine/vehicle/glider_profile.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/messages/fault.hpp"

namespace floeplan::vehicle {
namespace {

/// The name without its depth class: "slocum-g3-thruster" for "slocum-g3-200-thruster".
std::string name_but_for_depth(const GliderProfile& profile) {
  const std::string rating = "-" + std::to_string(std::lround(profile.depth_rating.value));
  std::string name = profile.name;
  if (const auto at = name.find(rating); at != std::string::npos) name.erase(at, rating.size());
  return name;
}

}  // namespace

core::Violations GliderProfile::violations() const {
  messages::Faults faults;
  faults.within(speed_through_water.value, 0.05, 5.0, "/speed_m_s", "0.05", "5 m/s");
  const double pitch_deg = core::radians_to_degrees(pitch.value);
  faults.require<"no-steady-glide">(pitch_deg >= least_pitch_deg - 1e-9 &&
                                        pitch_deg <= most_pitch_deg + 1e-9 &&
                                        glide_path_angle(hydrodynamics, pitch).has_value(),
                                    "/pitch_deg");
  faults.within(buoyancy.value, 1e-5, 1e-2, "/vehicle/buoyancy_cm3", "10", "10000 cm3");
  faults.within(depth_rating.value, 2.0, 11'000.0, "/vehicle/depth_rating_m", "2", "11000 m");
  faults.require<"not-at-least">(dive_depth.value >= 1.0 && dive_depth.value <= depth_rating.value,
                                 "/dive_depth_m", "1 m and no deeper than the vehicle's rating");
  faults.require<"negative">(climb_to.value >= 0.0, "/climb_to_m");
  faults.require<"not-at-least">(!(dive_depth.value < climb_to.value + lowest_tooth.value), "/climb_to_m",
                                 "2 m above the depth of the dives");
  faults.within(minimum_working_depth.value, 0.0, 11'000.0, "/vehicle/minimum_working_depth_m", "0",
                "11000 m");
  faults.within(altimeter_margin.value, 0.0, 1000.0, "/altimeter_margin_m", "0", "1000 m");
  faults.within(energy.hotel.value, 0.0, 1000.0, "/vehicle/hotel_w", "0", "1000 W");
  faults.within(energy.pump_efficiency, 0.01, 1.0, "/vehicle/pump_efficiency", "0.01", "1");
  faults.within(energy.pump_loss_j_cm3, 0.0, 1000.0, "/vehicle/pump_loss_j_cm3", "0", "1000 J/cm3");
  faults.within(energy.intake_j_cm3, 0.0, 1000.0, "/vehicle/intake_j_cm3", "0", "1000 J/cm3");
  faults.within(energy.inflection.value, 0.0, 1e6, "/vehicle/inflection_j", "0", "1e6 J");
  faults.within(energy.surfacing.value, 0.0, 1e7, "/vehicle/surfacing_j", "0", "1e7 J");
  if (energy.surfacing_interval)
    faults.within(energy.surfacing_interval->count(), 60.0, 1e7, "/vehicle/surfacing_interval_s", "60",
                  "1e7 s");
  faults.within(energy.battery.value, 1.0, 1e10, "/battery_j", "1", "1e10 J");
  faults.within(energy.battery_start_share, 0.0, 1.0, "/battery_start_share", "0", "1");
  faults.within(energy.battery_reserve_share, 0.0, 1.0, "/vehicle/battery_reserve_share", "0", "1");
  if (thruster) {
    faults.within(thruster->speed.value, 0.05, 5.0, "/vehicle/thruster/speed_m_s", "0.05", "5 m/s");
    faults.within(thruster->power.value, 0.0, 10'000.0, "/vehicle/thruster/power_w", "0", "10000 W");
  }
  faults.require<"not-at-least">(max_waypoints_per_list >= 1, "/vehicle/max_waypoints_per_list", "1");
  return faults.found();
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

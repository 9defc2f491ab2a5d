#include "engine/vehicle/glider_profile.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace floeplan::vehicle {
namespace {

/// Sources: horizontal speed 0.35 m/s on average and the depth ratings: Teledyne Webb Research, Slocum G3
/// glider data sheet. Waypoints in a list: eight slots in the vendor's data dictionary of firmware 10.5,
/// behavior goto_list. Minimum working depths leave the surface layer a glider climbs into (about 4 m), the
/// altimeter margin and some metres in which to saw-tooth; the deep vehicle's larger pump turns more slowly,
/// hence its 40 m (the data sheet's lower limit).
std::vector<GliderProfile> make_profiles() {
  return {
      {.name = "slocum-g3-200",
       .title = "Slocum G3, 200 m",
       .speed_through_water = {0.35},
       .dive_depth = {200.0},
       .depth_rating = {200.0},
       .minimum_working_depth = {20.0},
       .altimeter_margin = {10.0},
       .max_waypoints_per_list = 8},
      {.name = "slocum-g3-1000",
       .title = "Slocum G3, 1000 m",
       .speed_through_water = {0.35},
       .dive_depth = {1000.0},
       .depth_rating = {1000.0},
       .minimum_working_depth = {40.0},
       .altimeter_margin = {20.0},
       .max_waypoints_per_list = 8},
      {.name = "slocum-g3-30",
       .title = "Slocum G3, 30 m",
       .speed_through_water = {0.35},
       .dive_depth = {30.0},
       .depth_rating = {30.0},
       .minimum_working_depth = {12.0},
       .altimeter_margin = {5.0},
       .max_waypoints_per_list = 8},
  };
}

}  // namespace

core::Violations GliderProfile::violations() const {
  core::Violations found;
  const auto require = [&](bool holds, const char* field, const char* rule) {
    if (!holds) found.push_back({field, rule});
  };
  require(speed_through_water.value >= 0.05 && speed_through_water.value <= 5.0, "/speed_m_s",
          "must be between 0.05 and 5 m/s");
  require(dive_depth.value >= 1.0 && dive_depth.value <= depth_rating.value, "/dive_depth_m",
          "must be at least 1 m and no deeper than the vehicle's rating");
  require(depth_rating.value > 0.0 && depth_rating.value <= 11'000.0, "/vehicle",
          "has no plausible depth rating");
  require(minimum_working_depth.value >= 0.0, "/vehicle", "has a negative minimum working depth");
  require(altimeter_margin.value >= 0.0, "/vehicle", "has a negative altimeter margin");
  require(max_waypoints_per_list >= 1, "/vehicle", "must take at least one waypoint");
  return found;
}

std::span<const GliderProfile> known_profiles() {
  static const std::vector<GliderProfile> profiles = make_profiles();
  return profiles;
}

std::optional<GliderProfile> find_profile(std::string_view name) {
  const auto found = std::ranges::find(known_profiles(), name, &GliderProfile::name);
  if (found == known_profiles().end()) return std::nullopt;
  return *found;
}

}  // namespace floeplan::vehicle

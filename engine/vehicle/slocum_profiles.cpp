#include <string>
#include <vector>

#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::vehicle {
namespace {

/// Values that depend on the depth class of a Slocum.
/// Sources: depth ratings and 0.35 m/s on average: Teledyne Webb Research, Slocum glider data sheets. Pitch of
/// 26 degrees, climbs to 3 m (deep vehicles 5 to 10 m) and 260 cm3 for the oil pump: defaults and comments of
/// the vendor's data dictionary of firmware 10.5, behavior yo. 230 cm3 for the piston pump: what the shallow
/// Slocums amadeus (2014) and comet (2019) moved in the German Bight, by their public logs. Minimum working
/// depths leave the layer climbed into, the altimeter margin and some metres in which to saw-tooth; the deep
/// vehicle's oil pump turns more slowly, hence its 40 m (the data sheet's lower limit) and its wider margin.
struct DepthClass {
  const char* suffix;
  double rating_m;
  double climb_to_m;
  double minimum_working_depth_m;
  double altimeter_margin_m;
  double buoyancy_m3;
};
constexpr DepthClass shallow{"30", 30.0, 3.0, 12.0, 5.0, 230e-6};
constexpr DepthClass coastal{"200", 200.0, 5.0, 20.0, 10.0, 230e-6};
constexpr DepthClass deep{"1000", 1000.0, 10.0, 40.0, 20.0, 260e-6};

/// Sources: the G3 as in EnergyModel. A G2 carries 8 MJ in alkaline cells (Davis, Eriksen and Jones 2002,
/// Autonomous buoyancy-driven underwater gliders, in Technology and Applications of Autonomous Underwater
/// Vehicles, Taylor and Francis, table of Slocum Battery) and draws less: on equal batteries it lasts about 90
/// days where a G3 lasts 75 (Ocean Observatories Initiative, Testing of new glider models underway, 2021).
EnergyModel energy_of(int generation) {
  EnergyModel energy;
  if (generation == 2) {
    energy.hotel = {75.0 / 90.0 * energy.hotel.value};
    energy.battery = {8e6};
  }
  return energy;
}

GliderProfile slocum(int generation, const DepthClass& depth, bool with_thruster) {
  const std::string model = std::to_string(generation);
  const std::string rating = depth.suffix;
  GliderProfile profile{.name = "slocum-g" + model + "-" + rating,
                        .title = "Slocum G" + model + ", " + rating + " m",
                        .speed_through_water = {0.35},
                        .pitch = {core::degrees_to_radians(26.0)},
                        .buoyancy = {depth.buoyancy_m3},
                        .hydrodynamics = {},
                        .climb_to = {depth.climb_to_m},
                        .dive_depth = {depth.rating_m},
                        .depth_rating = {depth.rating_m},
                        .minimum_working_depth = {depth.minimum_working_depth_m},
                        .altimeter_margin = {depth.altimeter_margin_m},
                        .energy = energy_of(generation),
                        .thruster = {},
                        .max_waypoints_per_list = 8};  // slots of goto_list in the same data dictionary
  if (with_thruster) {
    // One knot: half of the maximum in the data sheet, with a quarter of the drag.
    constexpr core::MetresPerSecond one_knot{1852.0 / 3600.0};
    profile.name += "-thruster";
    profile.title += ", with thruster";
    profile.thruster = Thruster{.speed = one_knot, .power = thruster_power(one_knot)};
  }
  return profile;
}

std::vector<GliderProfile> make_profiles() {
  std::vector<GliderProfile> profiles;
  for (const int generation : {3, 2}) {
    for (const bool with_thruster : {false, true}) {
      for (const DepthClass& depth : {coastal, deep, shallow}) {
        profiles.push_back(slocum(generation, depth, with_thruster));
      }
    }
  }
  return profiles;
}

}  // namespace

std::span<const GliderProfile> known_profiles() {
  static const std::vector<GliderProfile> profiles = make_profiles();
  return profiles;
}

}  // namespace floeplan::vehicle

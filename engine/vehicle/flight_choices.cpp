#include "engine/vehicle/flight_choices.hpp"

namespace floeplan::vehicle {
namespace {

template <class T>
void choose(const std::optional<T>& choice, T& member) {
  if (choice) member = *choice;
}

}  // namespace

GliderProfile with_choices(GliderProfile profile, const FlightChoices& choices) {
  choose(choices.speed_through_water, profile.speed_through_water);
  choose(choices.pitch, profile.pitch);
  choose(choices.climb_to, profile.climb_to);
  choose(choices.dive_depth, profile.dive_depth);
  choose(choices.altimeter_margin, profile.altimeter_margin);
  choose(choices.battery, profile.energy.battery);
  choose(choices.battery_start_share, profile.energy.battery_start_share);
  return profile;
}

GliderProfile at_speed_of_glide(GliderProfile profile) {
  const auto steady = steady_glide(profile.hydrodynamics, profile.pitch, profile.buoyancy);
  if (steady) profile.speed_through_water = steady->horizontal;
  return profile;
}

bool is_known_but_for_choices(const GliderProfile& profile) {
  const auto known = find_profile(profile.name);
  if (!known) return false;
  return with_choices(*known, {.speed_through_water = profile.speed_through_water,
                               .pitch = profile.pitch,
                               .climb_to = profile.climb_to,
                               .dive_depth = profile.dive_depth,
                               .altimeter_margin = profile.altimeter_margin,
                               .battery = profile.energy.battery,
                               .battery_start_share = profile.energy.battery_start_share}) == profile;
}

}  // namespace floeplan::vehicle

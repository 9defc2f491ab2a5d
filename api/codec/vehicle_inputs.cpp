#include "api/codec/vehicle_inputs.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "api/codec/input_limits.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using vehicle::FlightChoices;
using vehicle::GliderProfile;

constexpr double cm3_per_m3 = 1e6;

/// Whether the inputs say the speed themselves, or what it follows from.
struct SpeedGiven {
  bool itself{false};
  bool by_glide{false};
};

void set(std::optional<double> value, double& member) {
  if (value) member = *value;
}

template <class Quantity>
std::optional<Quantity> quantity(std::optional<double> value) {
  return value ? std::optional{Quantity{*value}} : std::nullopt;
}

/// Adds what a pilot sets from mission to mission to the profile.
FlightChoices read_flight(InputReader& reader, GliderProfile& profile, SpeedGiven& given) {
  FlightChoices choices;
  choices.speed_through_water = quantity<core::MetresPerSecond>(reader.number("speed_m_s", {0.05, 5.0}));
  if (const auto pitch = reader.number("pitch_deg", {vehicle::least_pitch_deg, vehicle::most_pitch_deg}))
    choices.pitch = core::Radians{core::degrees_to_radians(*pitch)};
  choices.climb_to = quantity<core::Metres>(reader.number("climb_to_m", {0.0, deepest_m}));
  choices.dive_depth =
      quantity<core::Metres>(reader.number("dive_depth_m", {1.0, profile.depth_rating.value}));
  choices.altimeter_margin = quantity<core::Metres>(reader.number("altimeter_margin_m", {0.0, 1000.0}));
  choices.battery = quantity<core::Joules>(reader.number("battery_j", {1.0, 1e10}));
  choices.battery_start_share = reader.number("battery_start_share", {0.0, 1.0});
  given.itself = given.itself || choices.speed_through_water.has_value();
  given.by_glide = given.by_glide || choices.pitch.has_value();
  profile = vehicle::with_choices(std::move(profile), choices);
  return choices;
}

void read_thruster(InputReader& reader, GliderProfile& profile) {
  const json* value = reader.member("thruster");
  if (value == nullptr) return;
  if (value->is_boolean()) {
    if (!value->get<bool>()) profile.thruster.reset();
    if (value->get<bool>() && !profile.thruster) {
      reader.refuse("/thruster", "must say its speed_m_s, because the profile has no thruster");
    }
    return;
  }
  InputReader members{*value};
  vehicle::Thruster thruster = profile.thruster.value_or(vehicle::Thruster{});
  set(members.number("speed_m_s", {0.05, 5.0}), thruster.speed.value);
  thruster.power = vehicle::thruster_power(thruster.speed);
  set(members.number("power_w", {0.0, 10'000.0}), thruster.power.value);
  members.refuse_unknown();
  reader.refuse_all("/thruster", members.violations());
  profile.thruster = thruster;
}

/// What the vehicle is.
void read_build(InputReader& reader, GliderProfile& profile, SpeedGiven& given) {
  if (auto name = reader.text("name")) profile.name = std::move(*name);
  if (auto title = reader.text("title")) profile.title = std::move(*title);
  if (const auto volume = reader.number("buoyancy_cm3", {10.0, 10'000.0})) {
    profile.buoyancy = {*volume / cm3_per_m3};
    given.by_glide = true;
  }
  set(reader.number("parasite_drag", {0.01, 10.0}), profile.hydrodynamics.parasite_drag);
  set(reader.number("induced_drag", {0.0, 100.0}), profile.hydrodynamics.induced_drag);
  set(reader.number("lift_slope", {0.1, 100.0}), profile.hydrodynamics.lift_slope);
  set(reader.number("drag_area_m2", {0.001, 10.0}), profile.hydrodynamics.area_m2);
  if (const auto rating = reader.number("depth_rating_m", {2.0, deepest_m})) {
    profile.depth_rating = {*rating};
    profile.dive_depth = std::min(profile.dive_depth, profile.depth_rating);
  }
  set(reader.number("minimum_working_depth_m", {0.0, deepest_m}), profile.minimum_working_depth.value);
  vehicle::EnergyModel& energy = profile.energy;
  set(reader.number("hotel_w", {0.0, 1000.0}), energy.hotel.value);
  set(reader.number("pump_efficiency", {0.01, 1.0}), energy.pump_efficiency);
  set(reader.number("pump_loss_j_cm3", {0.0, 1000.0}), energy.pump_loss_j_cm3);
  set(reader.number("intake_j_cm3", {0.0, 1000.0}), energy.intake_j_cm3);
  set(reader.number("inflection_j", {0.0, 1e6}), energy.inflection.value);
  set(reader.number("surfacing_j", {0.0, 1e7}), energy.surfacing.value);
  if (const auto interval = reader.number("surfacing_interval_s", {60.0, 1e7})) {
    energy.surfacing_interval = core::Seconds{*interval};
  }
  set(reader.number("battery_reserve_share", {0.0, 1.0}), energy.battery_reserve_share);
  read_thruster(reader, profile);
  if (const auto waypoints = reader.integer("max_waypoints_per_list", 1, 10'000)) {
    profile.max_waypoints_per_list = *waypoints;
  }
}

/// The known profile of this name; the default and a note at `pointer` when there is none.
GliderProfile known(InputReader& reader, const std::string& pointer, const std::string& name) {
  if (const auto profile = vehicle::find_profile(name)) return *profile;
  std::string names;
  for (const auto& each : vehicle::known_profiles()) names += (names.empty() ? "" : ", ") + each.name;
  reader.refuse(pointer, "must be one of " + names + ", not \"" + name + "\"");
  return vehicle::known_profiles().front();
}

GliderProfile read_object(InputReader& reader, const json& object, SpeedGiven& given) {
  InputReader members{object};
  GliderProfile profile = vehicle::known_profiles().front();
  if (const auto name = members.text("profile")) profile = known(members, "/profile", *name);
  read_build(members, profile, given);
  read_flight(members, profile, given);
  members.refuse_unknown();
  reader.refuse_all("/vehicle", members.violations());
  return profile;
}

json flight_json(const GliderProfile& profile) {
  return {{"speed_m_s", profile.speed_through_water.value},
          {"pitch_deg", core::radians_to_degrees(profile.pitch.value)},
          {"climb_to_m", profile.climb_to.value},
          {"dive_depth_m", profile.dive_depth.value},
          {"altimeter_margin_m", profile.altimeter_margin.value},
          {"battery_j", profile.energy.battery.value},
          {"battery_start_share", profile.energy.battery_start_share}};
}

}  // namespace

FlightChoices read_vehicle(InputReader& reader, GliderProfile& profile) {
  SpeedGiven given;
  profile = vehicle::known_profiles().front();
  const json* value = reader.member("vehicle");
  if (value != nullptr && value->is_object()) {
    profile = read_object(reader, *value, given);
  } else if (const auto name = reader.text("vehicle")) {
    profile = known(reader, "/vehicle", *name);
  }
  const FlightChoices choices = read_flight(reader, profile, given);
  // Where the inputs leave the speed to pitch and buoyancy.
  if (given.by_glide && !given.itself) profile = vehicle::at_speed_of_glide(std::move(profile));
  for (const core::Violation& violation : profile.violations()) {
    if (!reader.refused(violation.field)) reader.refuse(violation.field, violation.rule);
  }
  return choices;
}

json vehicle_json(const GliderProfile& profile) {
  json result = flight_json(profile);
  const vehicle::EnergyModel& energy = profile.energy;
  result.update({{"name", profile.name},
                 {"title", profile.title},
                 {"buoyancy_cm3", profile.buoyancy.value * cm3_per_m3},
                 {"parasite_drag", profile.hydrodynamics.parasite_drag},
                 {"induced_drag", profile.hydrodynamics.induced_drag},
                 {"lift_slope", profile.hydrodynamics.lift_slope},
                 {"drag_area_m2", profile.hydrodynamics.area_m2},
                 {"depth_rating_m", profile.depth_rating.value},
                 {"minimum_working_depth_m", profile.minimum_working_depth.value},
                 {"hotel_w", energy.hotel.value},
                 {"pump_efficiency", energy.pump_efficiency},
                 {"pump_loss_j_cm3", energy.pump_loss_j_cm3},
                 {"intake_j_cm3", energy.intake_j_cm3},
                 {"inflection_j", energy.inflection.value},
                 {"surfacing_j", energy.surfacing.value},
                 {"surfacing_interval_s",
                  energy.surfacing_interval ? json(energy.surfacing_interval->count()) : json()},
                 {"battery_reserve_share", energy.battery_reserve_share},
                 {"thruster", false},
                 {"max_waypoints_per_list", profile.max_waypoints_per_list}});
  if (profile.thruster) {
    result["thruster"] = {{"speed_m_s", profile.thruster->speed.value},
                          {"power_w", profile.thruster->power.value}};
  }
  return result;
}

void write_vehicle(const GliderProfile& profile, json& inputs) {
  inputs["vehicle"] = vehicle::is_known_but_for_choices(profile) ? json(profile.name) : vehicle_json(profile);
  inputs.update(flight_json(profile));
}

}  // namespace floeplan::codec

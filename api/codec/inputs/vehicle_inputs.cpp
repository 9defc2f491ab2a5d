#include "api/codec/inputs/vehicle_inputs.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "api/codec/reading/input_fields.hpp"
#include "api/fields/request_fields.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;
using vehicle::FlightChoices;
using vehicle::GliderProfile;

/// Whether the inputs state the speed, or values from which it follows.
struct SpeedGiven {
  bool itself{false};
  bool by_glide{false};
};

/// Fields of the flight, with the dive depth limited to the vehicle's depth rating.
fields::Table<FlightChoices> flight_fields(core::Metres rating) {
  fields::Table<FlightChoices> table = fields::flight_fields();
  for (auto& row : table)
    if (row.field.name == "dive_depth_m") row.field.most = rating.value;
  return table;
}

/// Reads the settings that a pilot changes between missions into the profile.
FlightChoices read_flight(InputReader& reader, GliderProfile& profile, SpeedGiven& given) {
  FlightChoices choices;
  read_fields(reader, flight_fields(profile.depth_rating), choices);
  given.itself = given.itself || choices.speed_through_water.has_value();
  given.by_glide = given.by_glide || choices.pitch.has_value();
  profile = vehicle::with_choices(std::move(profile), choices);
  return choices;
}

/// The settings that can be chosen for a flight, with the profile's values.
FlightChoices choices_of(const GliderProfile& profile) {
  return {.speed_through_water = profile.speed_through_water,
          .pitch = profile.pitch,
          .climb_to = profile.climb_to,
          .dive_depth = profile.dive_depth,
          .altimeter_margin = profile.altimeter_margin,
          .battery = profile.energy.battery,
          .battery_start_share = profile.energy.battery_start_share};
}

void read_thruster(InputReader& reader, GliderProfile& profile) {
  const json* value = reader.member("thruster");
  if (value == nullptr) return;
  if (value->is_boolean()) {
    if (!value->get<bool>()) profile.thruster.reset();
    if (value->get<bool>() && !profile.thruster) {
      reader.refuse<"thruster-without-speed">("/thruster");
    }
    return;
  }
  InputReader members{*value};
  vehicle::Thruster thruster = profile.thruster.value_or(vehicle::Thruster{});
  read_fields(members, fields::thruster_fields(), thruster);
  if (members.member("power_w") == nullptr) thruster.power = vehicle::thruster_power(thruster.speed);
  members.refuse_unknown();
  reader.refuse_all("/thruster", members.violations());
  profile.thruster = thruster;
}

/// Reads the members of the vehicle's build.
void read_build(InputReader& reader, GliderProfile& profile, SpeedGiven& given) {
  read_fields(reader, fields::build_fields(), profile);
  if (reader.member("buoyancy_cm3") != nullptr) given.by_glide = true;
  if (reader.member("depth_rating_m") != nullptr)
    profile.dive_depth = std::min(profile.dive_depth, profile.depth_rating);
  read_thruster(reader, profile);
}

/// The known profile with this name; if there is none, a violation at `pointer` and the default.
GliderProfile known(InputReader& reader, const std::string& pointer, const std::string& name) {
  if (const auto profile = vehicle::find_profile(name)) return *profile;
  std::string names;
  for (const auto& each : vehicle::known_profiles()) names += (names.empty() ? "" : ", ") + each.name;
  reader.refuse<"wrong-shape-found">(pointer, "one of " + names, "\"" + name + "\"");
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
  // The speed follows from pitch and buoyancy if the inputs do not state it.
  if (given.by_glide && !given.itself) profile = vehicle::at_speed_of_glide(std::move(profile));
  reader.refuse_rest(profile.violations());
  return choices;
}

json vehicle_json(const GliderProfile& profile) {
  json result{{"thruster", false}};
  write_fields(fields::flight_fields(), choices_of(profile), result);
  write_fields(fields::build_fields(), profile, result);
  if (profile.thruster)
    write_fields(fields::thruster_fields(), *profile.thruster, result["thruster"] = json::object());
  return result;
}

void write_vehicle(const GliderProfile& profile, json& inputs) {
  inputs["vehicle"] = vehicle::is_known_but_for_choices(profile) ? json(profile.name) : vehicle_json(profile);
  write_fields(fields::flight_fields(), choices_of(profile), inputs);
}

}  // namespace floeplan::codec

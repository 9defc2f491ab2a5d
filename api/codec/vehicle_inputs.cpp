#include "api/codec/vehicle_inputs.hpp"

#include <nlohmann/json.hpp>

namespace floeplan::codec {

using nlohmann::json;

void read_vehicle(InputReader& reader, vehicle::GliderProfile& profile) {
  profile = vehicle::known_profiles().front();
  if (const auto name = reader.text("vehicle")) {
    if (const auto known = vehicle::find_profile(*name)) {
      profile = *known;
    } else {
      std::string names;
      for (const auto& each : vehicle::known_profiles()) names += (names.empty() ? "" : ", ") + each.name;
      reader.refuse("/vehicle", "must be one of " + names + ", not \"" + *name + "\"");
    }
  }
  if (const auto speed = reader.number("speed_m_s", {0.05, 5.0})) profile.speed_through_water = {*speed};
  if (const auto depth = reader.number("dive_depth_m", {1.0, profile.depth_rating.value})) {
    profile.dive_depth = {*depth};
  }
}

void write_vehicle(const vehicle::GliderProfile& profile, json& inputs) {
  inputs["vehicle"] = profile.name;
  inputs["speed_m_s"] = profile.speed_through_water.value;
  inputs["dive_depth_m"] = profile.dive_depth.value;
}

}  // namespace floeplan::codec

#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/input_reader.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::codec {

/// The vehicle: a known profile by name, with what the request changes of it.
void read_vehicle(InputReader& reader, vehicle::GliderProfile& profile);
/// Adds the members that `read_vehicle` reads, every default written out.
void write_vehicle(const vehicle::GliderProfile& profile, nlohmann::json& inputs);

}  // namespace floeplan::codec

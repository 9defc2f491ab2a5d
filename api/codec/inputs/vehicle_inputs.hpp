#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "engine/vehicle/flight_choices.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::codec {

/// The vehicle: the name of a known profile, or an object that names one in "profile" and overrides any of its
/// members; beside it the members of its flight (speed, pitch, depths, battery), which win over both. A pitch
/// or buoyancy without a speed gives the speed of the steady glide.
/// Returns  what the members beside it say
vehicle::FlightChoices read_vehicle(InputReader& reader, vehicle::GliderProfile& profile);
/// Adds the members that `read_vehicle` reads, every default written out.
void write_vehicle(const vehicle::GliderProfile& profile, nlohmann::json& inputs);

/// Every member of a profile, under the names that the object "vehicle" of the inputs has.
[[nodiscard]] nlohmann::json vehicle_json(const vehicle::GliderProfile& profile);

}  // namespace floeplan::codec

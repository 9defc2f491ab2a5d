#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "engine/vehicle/flight_choices.hpp"
#include "engine/vehicle/glider_profile.hpp"

namespace floeplan::codec {

/// Reads the vehicle: the name of a known profile, or an object that names one in "profile" and overrides any
/// of its members. Members for the flight beside it (speed, pitch, depths, battery) have priority over both.
/// A pitch or buoyancy without a speed gives the speed of a steady glide.
/// Returns  the members for the flight
vehicle::FlightChoices read_vehicle(InputReader& reader, vehicle::GliderProfile& profile);
/// Adds the members that `read_vehicle` reads, with all defaults filled in.
void write_vehicle(const vehicle::GliderProfile& profile, nlohmann::json& inputs);

/// All members of a profile, with the names that the input object "vehicle" uses.
[[nodiscard]] nlohmann::json vehicle_json(const vehicle::GliderProfile& profile);

}  // namespace floeplan::codec

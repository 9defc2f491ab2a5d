#pragma once

#include <nlohmann/json_fwd.hpp>

#include "api/codec/reading/input_reader.hpp"
#include "engine/simulation/sensors/adcp_settings.hpp"
#include "engine/simulation/sensors/altimeter.hpp"
#include "engine/simulation/sensors/sonar_settings.hpp"

namespace floeplan::codec {

/// Reads settings of simulated sensors. The member `key` of the inputs is an object with those that differ
/// from the defaults. Angles are in degrees, all other numbers in the unit in their name.
[[nodiscard]] simulation::SonarSettings read_sonar(InputReader& reader, const std::string& key);
[[nodiscard]] simulation::AltimeterSettings read_altimeter(InputReader& reader, const std::string& key);
[[nodiscard]] simulation::AdcpSettings read_adcp(InputReader& reader, const std::string& key);

/// All settings of a sensor as JSON.
[[nodiscard]] nlohmann::json sonar_json(const simulation::SonarSettings& settings);
[[nodiscard]] nlohmann::json altimeter_json(const simulation::AltimeterSettings& settings);
[[nodiscard]] nlohmann::json adcp_json(const simulation::AdcpSettings& settings);

}  // namespace floeplan::codec

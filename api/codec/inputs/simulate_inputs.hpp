#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "engine/core/violation.hpp"
#include "engine/simulation/flight/flight.hpp"
#include "engine/simulation/sensors/adcp_settings.hpp"
#include "engine/simulation/sensors/altimeter.hpp"
#include "engine/simulation/sensors/sonar_settings.hpp"
#include "engine/simulation/world/current_error_field.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

/// Largest number of flights in a batch, and of flights whose track is stored.
inline constexpr int most_runs = 10'000;
inline constexpr int most_tracks = 100;

struct SimulatedFile {
  std::string name;
  std::string text;
};

/// Inputs of process simulate-plan.
struct SimulateInputs {
  std::string plan_id;
  std::vector<SimulatedFile>
      // files to fly instead of the plan's own mission files; empty: the plan's own
      mission_files;
  std::optional<std::string> vehicle;  // name of the vehicle; must be the plan's
  int runs{1};
  std::uint64_t seed{1};
  int tracks{1};         // number of flights whose track is stored: the first ones
  bool avoidance{true};  // simulates sonar, ADCP and the onboard avoidance system
  simulation::CurrentErrorSettings current_error{};
  simulation::SonarSettings sonar{};
  simulation::AltimeterSettings altimeter{};
  simulation::AdcpSettings adcp{};
  simulation::FlightSettings flight{.record_every = core::Seconds{60.0}};
  std::optional<core::Seconds> longest;  // longest duration of a flight; empty: derived from the plan
  nlohmann::json data =
      nlohmann::json::object();  // members of plan inputs that choose other data than the plan's
  std::string name;
};

/// Errors   every violation at once, each with the JSON pointer of its value relative to `inputs`
[[nodiscard]] tl::expected<SimulateInputs, core::Violations> parse_simulate_inputs(
    const nlohmann::json& inputs);

/// The inputs with all defaults filled in and keys in a fixed order, so that equal requests give equal texts.
[[nodiscard]] nlohmann::json to_json(const SimulateInputs& inputs);

}  // namespace floeplan::codec

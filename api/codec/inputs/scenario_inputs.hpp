#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

#include "engine/core/violation.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

inline constexpr const char* random_icebergs = "random-icebergs";

/// Inputs of process fly-scenario.
struct ScenarioInputs {
  std::string scenario{random_icebergs};  // the only one so far
  int runs{1};                            // at most simulate-plan's `most_runs`
  std::uint64_t seed{1};
  bool avoidance{true};  // simulates sonar, ADCP and the onboard avoidance system
};

/// Errors   every violation at once, each with the JSON pointer of its value relative to `inputs`
[[nodiscard]] tl::expected<ScenarioInputs, core::Violations> parse_scenario_inputs(
    const nlohmann::json& inputs);

/// The inputs with all defaults filled in.
[[nodiscard]] nlohmann::json to_json(const ScenarioInputs& inputs);

}  // namespace floeplan::codec

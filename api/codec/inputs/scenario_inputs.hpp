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
  int runs{1};                            // at most `most_runs` of simulate-plan
  std::uint64_t seed{1};
  bool avoidance{true};  // with sonar, ADCP and the obstacle avoidance system on board
};

/// Errors   every violation at once, each with the JSON pointer of its value relative to `inputs`
[[nodiscard]] tl::expected<ScenarioInputs, core::Violations> parse_scenario_inputs(
    const nlohmann::json& inputs);

/// The inputs with every default written out.
[[nodiscard]] nlohmann::json to_json(const ScenarioInputs& inputs);

}  // namespace floeplan::codec

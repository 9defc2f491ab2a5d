#include "api/codec/inputs/scenario_inputs.hpp"

#include "api/codec/inputs/simulate_inputs.hpp"
#include "api/codec/reading/input_reader.hpp"
#include "api/fields/limits.hpp"

namespace floeplan::codec {

using nlohmann::json;

tl::expected<ScenarioInputs, core::Violations> parse_scenario_inputs(const json& inputs) {
  InputReader reader{inputs};
  ScenarioInputs result;
  reader.require("scenario", "random-icebergs");
  if (const auto scenario = reader.text("scenario"); scenario && *scenario != random_icebergs)
    reader.refuse<"wrong-shape">("/scenario", "random-icebergs, the only scenario so far");
  result.runs = reader.integer("runs", 1, most_runs).value_or(result.runs);
  result.seed = static_cast<std::uint64_t>(reader.integer("seed", 0, fields::largest_seed).value_or(1));
  result.avoidance = reader.boolean("avoidance").value_or(result.avoidance);
  reader.refuse_unknown();
  if (!reader.violations().empty()) return tl::unexpected(reader.violations());
  return result;
}

json to_json(const ScenarioInputs& inputs) {
  return {{"scenario", inputs.scenario},
          {"runs", inputs.runs},
          {"seed", inputs.seed},
          {"avoidance", inputs.avoidance}};
}

}  // namespace floeplan::codec

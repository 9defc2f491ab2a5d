#include "api/codec/inputs/plan_input_parts.hpp"
#include "api/codec/reading/input_fields.hpp"
#include "api/fields/request_fields.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

void read_objective(InputReader& reader, planning::Objective& objective) {
  const json* value = reader.member("objective");
  if (value == nullptr) return;
  if (*value == "time") {
    objective = planning::time_objective;
  } else if (*value == "energy") {
    objective = planning::energy_objective;
  } else if (value->is_object()) {
    InputReader members{*value};
    objective = {.of_time = 0.0, .of_energy = 0.0};
    read_fields(members, fields::weight_fields(), objective);
    members.refuse_unknown();
    if (members.violations().empty() && !(objective.of_time + objective.of_energy > 0.0)) {
      members.refuse<"no-weight">("");
    }
    reader.refuse_all("/objective", members.violations());
  } else {
    reader.refuse<"wrong-shape-found">(
        "/objective", "\"time\", \"energy\" or {\"time\": weight of a second, \"energy\": weight of a joule}",
        shown(*value));
  }
}

json objective_json(const planning::Objective& objective) {
  if (objective == planning::time_objective) return "time";
  if (objective == planning::energy_objective) return "energy";
  json weights;
  write_fields(fields::weight_fields(), objective, weights);
  return weights;
}

}  // namespace

void read_energy(InputReader& reader, planning::EnergyRules& rules) {
  read_objective(reader, rules.objective);
  read_fields(reader, fields::energy_fields(), rules);
}

void write_energy(const planning::EnergyRules& rules, json& inputs) {
  inputs["objective"] = objective_json(rules.objective);
  write_fields(fields::energy_fields(), rules, inputs);
}

}  // namespace floeplan::codec

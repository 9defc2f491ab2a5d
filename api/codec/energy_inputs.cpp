#include "api/codec/energy_inputs.hpp"

#include "storage/json/json.hpp"

namespace floeplan::codec {
namespace {

using nlohmann::json;

constexpr NumberRange weights{0.0, 1e6};

void read_objective(InputReader& reader, planning::Objective& objective) {
  const json* value = reader.member("objective");
  if (value == nullptr) return;
  if (*value == "time") {
    objective = planning::time_objective;
  } else if (*value == "energy") {
    objective = planning::energy_objective;
  } else if (value->is_object()) {
    InputReader members{*value};
    objective = {.of_time = members.number("time", weights).value_or(0.0),
                 .of_energy = members.number("energy", weights).value_or(0.0)};
    members.refuse_unknown();
    if (members.violations().empty() && !(objective.of_time + objective.of_energy > 0.0)) {
      members.refuse("", "must give time or energy a weight above zero");
    }
    reader.refuse_all("/objective", members.violations());
  } else {
    reader.refuse("/objective",
                  "must be \"time\", \"energy\" or {\"time\": weight of a second, \"energy\": weight of a "
                  "joule}, not " +
                      shown(*value));
  }
}

json objective_json(const planning::Objective& objective) {
  if (objective == planning::time_objective) return "time";
  if (objective == planning::energy_objective) return "energy";
  return {{"time", objective.of_time}, {"energy", objective.of_energy}};
}

}  // namespace

void read_energy(InputReader& reader, planning::EnergyRules& rules) {
  read_objective(reader, rules.objective);
  if (const auto text = reader.text("thruster")) {
    if (const auto use = planning::parse_thruster_use(*text)) {
      rules.thruster = *use;
    } else {
      reader.refuse("/thruster", "must be auto, on or off, not \"" + *text + "\"");
    }
  }
  if (const auto required = reader.boolean("require_battery")) rules.require_battery = *required;
}

void write_energy(const planning::EnergyRules& rules, json& inputs) {
  inputs["objective"] = objective_json(rules.objective);
  inputs["thruster"] = planning::thruster_use_name(rules.thruster);
  inputs["require_battery"] = rules.require_battery;
}

}  // namespace floeplan::codec

#include "engine/mission/document/behavior_values.hpp"

#include "engine/mission/document/argument_rules.hpp"
#include "engine/mission/document/behavior_table.hpp"

namespace floeplan::mission {

std::optional<double> value_of(const Behavior& behavior, std::string_view name) {
  if (const Argument* given = behavior.find(name)) {
    if (is_mission_parameter(given->value)) return std::nullopt;
    return given->value;
  }
  const BehaviorRule* rule = find_behavior(behavior.name);
  const ArgumentRule* known = rule == nullptr ? nullptr : rule->find(name);
  return known == nullptr ? std::nullopt : known->by_default;
}

bool reads_file(const Behavior& behavior) {
  const Argument* file = behavior.find("args_from_file");
  return file != nullptr && file->value >= 0.0;
}

}  // namespace floeplan::mission

#include "engine/mission/document/argument_rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "engine/core/near_word.hpp"
#include "engine/messages/mission_file_messages.hpp"
#include "engine/mission/document/behavior_table.hpp"
#include "engine/mission/document/thruster_yo.hpp"

namespace floeplan::mission {
namespace {

constexpr int largest_file_number = 99;  // file names are 8.3, so the number has two digits

void report(Messages& messages, int line, const messages::Message& message) {
  messages.push_back(finding(line, message));
}

void check_unknown(const Behavior& behavior, const BehaviorRule& rule, const Argument& argument,
                   Messages& messages) {
  if (!rule.complete) return;
  if (const BehaviorRule* owner = sole_owner(argument.name)) {
    report(messages, argument.line,
           messages::mission_file_message<"b_arg_of_another_behavior">(argument.name, owner->name,
                                                                       behavior.name));
    return;
  }
  std::vector<std::string> known;
  for (const ArgumentRule& one : rule.arguments) known.emplace_back(one.name);
  const std::string meant = core::near_word(argument.name, known);
  report(messages, argument.line,
         meant.empty()
             ? messages::mission_file_message<"unknown_b_arg">(argument.name, behavior.name)
             : messages::mission_file_message<"misspelt_b_arg">(argument.name, behavior.name, meant));
}

void check_known(const Argument& argument, const ArgumentRule& rule, Messages& messages) {
  if (!argument.unit.empty() && argument.unit != rule.unit) {
    report(messages, argument.line, messages::mission_file_message<"unit_differs">(argument.name, rule.unit));
  }
  if (is_mission_parameter(argument.value)) {
    report(messages, argument.line, messages::mission_file_message<"mission_parameter">(argument.name));
    return;
  }
  const bool below = rule.least && argument.value < *rule.least;
  const bool above = rule.most && argument.value > *rule.most;
  if (below || above) {
    report(messages, argument.line,
           messages::mission_file_message<"value_out_of_dictionary_range">(argument.name, argument.raw));
  }
}

/// Checks a thruster's value. Its meaning, and so its range, depends on the mode in the argument beside it.
void check_thruster_value(const Behavior& behavior, const Argument& argument, Messages& messages) {
  constexpr std::string_view suffix = "thruster_value";
  if (!argument.name.ends_with(suffix) || is_mission_parameter(argument.value)) return;
  const std::string prefix = argument.name.substr(0, argument.name.size() - suffix.size());
  const Argument* mode = behavior.find(prefix + "use_thruster");
  if (mode == nullptr) return;
  const bool is_share = mode->value == 1.0 || mode->value == 2.0;
  const bool is_power = mode->value == thruster_by_power;
  if (!is_share && !is_power) return;
  const double least = is_power ? least_thruster_power.value : 0.0;
  const double most = is_power ? most_thruster_power.value : 100.0;
  if (argument.value >= least && argument.value <= most) return;
  report(messages, argument.line,
         messages::mission_file_message<"value_out_of_dictionary_range/thruster">(
             argument.name, argument.raw, mode->name, mode->raw, is_power ? "1 to 9 W" : "0 to 100 %"));
}

void check_file_number(const Behavior& behavior, const Argument& argument, Messages& messages) {
  if (argument.value != std::floor(argument.value) || argument.value < -1.0) {
    report(messages, argument.line, messages::mission_file_message<"bad_file_number">());
  } else if (argument.value > largest_file_number) {
    report(messages, argument.line, messages::mission_file_message<"file_number_above_99">());
  } else if ((behavior.name == "goto_list" && argument.value >= 98.0) ||
             (behavior.name == "yo" && argument.value == 99.0)) {
    report(messages, argument.line, messages::mission_file_message<"file_number_of_firmware">());
  }
}

constexpr int last_code = 18;

constexpr std::uint32_t codes(std::initializer_list<int> allowed) {
  std::uint32_t bits = 0;
  for (const int code : allowed) bits |= 1U << code;
  return bits;
}

struct CodeRule {
  std::string_view behavior;
  std::string_view argument;
  std::uint32_t allowed;  // one bit for each allowed code
};

constexpr std::array code_rules{
    CodeRule{"surface", "start_when", codes({0, 1, 2, 3, 6, 7, 8, 9, 10, 11, 12, 13, 16})},
    CodeRule{"goto_wpt", "start_when", codes({0, 1, 2, 4})},
    CodeRule{"goto_wpt", "stop_when", codes({1, 2, 5, 7})},
    CodeRule{"goto_list", "list_stop_when", codes({1, 2, 5, 7, 15})},
    CodeRule{"yo", "start_when", codes({0, 1, 2, 4, 7, 8, 15, 17, 18})},
    CodeRule{"prepare_to_dive", "start_when", codes({0, 1, 2})},
    CodeRule{"drift_at_depth", "start_when", codes({0, 1, 2, 3, 4, 6, 7, 8, 9, 10, 13})},
    CodeRule{"set_heading", "start_when", codes({0, 1, 2, 6, 7, 8, 15})},
    CodeRule{"set_heading", "stop_when", codes({1, 2, 5, 6, 7, 8, 15})},
};

bool holds_code(std::string_view argument) {
  return argument == "start_when" || argument == "stop_when" || argument == "list_stop_when" ||
         argument == "primary_stop_when";
}

/// Notes codes of start_when, stop_when and similar arguments that firmware 10.5 does not have, or not for
/// this behavior. Codes above 14 differ between firmware versions, so they get at most a note.
/// Source   facts from the vendor's data dictionary of firmware 10.5: codes 0 to 18, and which of them each
///          behavior takes
void check_code(std::string_view behavior, const Argument& argument, Messages& messages) {
  if (!holds_code(argument.name) || is_mission_parameter(argument.value)) return;
  const bool exists =
      argument.value == std::floor(argument.value) && argument.value >= 0.0 && argument.value <= last_code;
  const auto rule = std::ranges::find_if(
      code_rules, [&](const CodeRule& r) { return r.behavior == behavior && r.argument == argument.name; });
  const bool allowed =
      exists && (rule == code_rules.end() || (rule->allowed >> static_cast<int>(argument.value) & 1U) != 0U);
  if (allowed) return;
  report(messages, argument.line,
         messages::mission_file_message<"unknown_code">(argument.name, argument.raw, behavior));
}

/// The message about a setting that is given twice. `conflicts`: different values are an error, as for a b_arg,
/// because it is unknown which of two values counts.
messages::Message duplicate(const Argument& setting, const Argument& first, bool conflicts) {
  const auto told = [&]<messages::Code other, messages::Code same>() {
    return first.value == setting.value ? messages::mission_file_message<same>(setting.name, first.line)
                                        : messages::mission_file_message<other>(setting.name, first.line);
  };
  return conflicts ? told.operator()<"duplicate_b_arg", "duplicate_b_arg/same">()
                   : told.operator()<"duplicate_sensor", "duplicate_sensor/same">();
}

}  // namespace

void check_duplicates(const std::vector<Argument>& settings, bool conflicts, Messages& messages) {
  std::map<std::string_view, const Argument*> seen;
  for (const Argument& setting : settings) {
    const auto [first, fresh] = seen.emplace(setting.name, &setting);
    if (fresh) continue;
    report(messages, setting.line, duplicate(setting, *first->second, conflicts));
  }
}

void check_arguments(const Behavior& behavior, Messages& messages) {
  check_duplicates(behavior.arguments, true, messages);
  const BehaviorRule* rule = find_behavior(behavior.name);
  if (rule == nullptr) {
    if (!behavior.name.empty()) {
      report(messages, behavior.line, messages::mission_file_message<"unknown_behavior">(behavior.name));
    }
    return;
  }
  if (behavior.name != behavior.written) {
    report(messages, behavior.line,
           messages::mission_file_message<"capital_letters">(behavior.name, behavior.written));
  }
  for (const Argument& argument : behavior.arguments) {
    check_code(behavior.name, argument, messages);
    if (argument.name != argument.written) {
      report(messages, argument.line,
             messages::mission_file_message<"capital_letters">(argument.name, argument.written));
    }
    if (argument.name == "args_from_file") check_file_number(behavior, argument, messages);
    check_thruster_value(behavior, argument, messages);
    if (const ArgumentRule* known = rule->find(argument.name)) {
      check_known(argument, *known, messages);
    } else {
      check_unknown(behavior, *rule, argument, messages);
    }
  }
}

}  // namespace floeplan::mission

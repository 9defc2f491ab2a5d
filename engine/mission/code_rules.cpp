#include "engine/mission/code_rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "engine/mission/argument_rules.hpp"

namespace floeplan::mission {
namespace {

constexpr int last_code = 18;

constexpr std::uint32_t codes(std::initializer_list<int> allowed) {
  std::uint32_t bits = 0;
  for (const int code : allowed) bits |= 1U << code;
  return bits;
}

struct CodeRule {
  std::string_view behavior;
  std::string_view argument;
  std::uint32_t allowed;  // a bit for each code
};

constexpr std::array rules{
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

}  // namespace

void check_code(std::string_view behavior, const Argument& argument, Messages& messages) {
  if (!holds_code(argument.name) || is_mission_parameter(argument.value)) return;
  const bool exists =
      argument.value == std::floor(argument.value) && argument.value >= 0.0 && argument.value <= last_code;
  const auto rule = std::ranges::find_if(
      rules, [&](const CodeRule& r) { return r.behavior == behavior && r.argument == argument.name; });
  const bool allowed =
      exists && (rule == rules.end() || (rule->allowed >> static_cast<int>(argument.value) & 1U) != 0U);
  if (allowed) return;
  messages.push_back({argument.line, Severity::note, "unknown_code",
                      argument.name + " " + argument.raw + " is no code that " + std::string{behavior} +
                          " takes in firmware 10.5"});
}

}  // namespace floeplan::mission

#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace floeplan::mission {

/// The firmware dictionary's facts about one b_arg. Members are empty if the dictionary gives none.
struct ArgumentRule {
  std::string_view name;
  std::string_view unit;
  std::optional<double> by_default{};
  std::optional<double> least{};
  std::optional<double> most{};
};

/// The firmware dictionary's facts about one behavior.
struct BehaviorRule {
  std::string_view name;
  std::span<const ArgumentRule> arguments;
  bool complete{true};  // false: it has further arguments that are not listed here

  [[nodiscard]] const ArgumentRule* find(std::string_view argument) const;
};

/// The behavior with this name in lower case; nullptr if it is not listed here, which newer or older firmware
/// may well have.
/// Source   facts from the vendor's data dictionary of firmware 10.5 (2020-11); arguments of older firmware
///          that operators still write are listed with their unit alone
[[nodiscard]] const BehaviorRule* find_behavior(std::string_view name);

/// The only behavior with an argument of this name; nullptr if none or several have it.
[[nodiscard]] const BehaviorRule* sole_owner(std::string_view argument);

/// Prefix of the names of a behavior's argument files, such as "goto_l" for goto_list: the first six letters
/// of its name.
[[nodiscard]] std::string_view file_prefix(std::string_view behavior);

/// The behavior whose argument files begin with `prefix`; nullptr if there is none.
[[nodiscard]] const BehaviorRule* find_by_file_prefix(std::string_view prefix);

}  // namespace floeplan::mission

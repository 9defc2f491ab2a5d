#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace floeplan::mission {

/// What the firmware's dictionary says of one b_arg. Empty where it gives nothing.
struct ArgumentRule {
  std::string_view name;
  std::string_view unit;
  std::optional<double> by_default{};
  std::optional<double> least{};
  std::optional<double> most{};
};

/// What the firmware's dictionary says of one behavior.
struct BehaviorRule {
  std::string_view name;
  std::span<const ArgumentRule> arguments;
  bool complete{true};  // false: it takes more arguments than are listed here

  [[nodiscard]] const ArgumentRule* find(std::string_view argument) const;
};

/// Behaviors by name in lower case; nullptr for one that is not known here, which newer or older firmware may
/// well have.
/// Source   facts from the vendor's data dictionary of firmware 10.5 (2020-11); arguments of older firmware
///          that operators still write are listed with their unit alone
[[nodiscard]] const BehaviorRule* find_behavior(std::string_view name);

/// The one behavior that alone takes an argument of this name; nullptr when none or several do.
[[nodiscard]] const BehaviorRule* sole_owner(std::string_view argument);

/// Name of the file that a behavior's `args_from_file` NN stands for, as "goto_l" for goto_list: the first six
/// letters of its name.
[[nodiscard]] std::string_view file_prefix(std::string_view behavior);

/// The behavior whose argument files begin with `prefix`; nullptr when none does.
[[nodiscard]] const BehaviorRule* find_by_file_prefix(std::string_view prefix);

}  // namespace floeplan::mission

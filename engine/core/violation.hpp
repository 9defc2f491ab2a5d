#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace floeplan::core {

/// A value that a message names: a number in the unit in its name ("error_km"), a count, or text. A time is
/// text in ISO 8601.
using Value = std::variant<double, std::int64_t, std::string>;

struct NamedValue {
  std::string name;
  Value value;

  friend bool operator==(const NamedValue&, const NamedValue&) = default;
  /// For core::packed.
  friend auto members_of(NamedValue& named) {
    auto& [name, value] = named;
    return std::tie(name, value);
  }
};

/// One rule that data from outside break. All violations are reported together, not only the first one.
struct Violation {
  std::string field;   // where: a JSON pointer ("/departure"), a flag ("--depart") or a variable of a file
                       // ("uo.units")
  std::string rule;    // for a person: the rule, the value found and how to correct it
  std::string code{};  // for programs: row in the catalogue of messages; empty: none
  std::vector<NamedValue> values{};  // values that the rule names

  friend bool operator==(const Violation&, const Violation&) = default;
};

using Violations = std::vector<Violation>;

}  // namespace floeplan::core

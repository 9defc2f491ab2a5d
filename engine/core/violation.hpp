#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace floeplan::core {

/// What a message speaks of: a number in the unit that its name ends in ("error_km"), a count, or words; a moment is
/// words in ISO 8601.
using Value = std::variant<double, std::int64_t, std::string>;

struct NamedValue {
  std::string name;
  Value value;

  friend bool operator==(const NamedValue&, const NamedValue&) = default;
};

/// One rule that outside data breaks. All of them are reported at once, never the first one alone.
struct Violation {
  std::string field;  // where: a JSON pointer ("/departure"), a flag ("--depart") or a variable of a file
                      // ("uo.units")
  std::string rule;   // what must hold, with the value found and a way out, for a person
  std::string code{};                // for programs: the rule's row in the catalogue of messages; empty: of none
  std::vector<NamedValue> values{};  // that the rule speaks of

  friend bool operator==(const Violation&, const Violation&) = default;
};

using Violations = std::vector<Violation>;

}  // namespace floeplan::core

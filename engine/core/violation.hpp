#pragma once

#include <string>
#include <vector>

namespace floeplan::core {

/// One rule that outside data breaks. All of them are reported at once, never the first one alone.
struct Violation {
  std::string field;  // where: a JSON pointer ("/departure"), a flag ("--depart") or a variable of a file
                      // ("uo.units")
  std::string rule;   // what must hold, with the value found and a way out, for a person

  friend bool operator==(const Violation&, const Violation&) = default;
};

using Violations = std::vector<Violation>;

}  // namespace floeplan::core

#pragma once

#include <string>
#include <utility>

#include "engine/core/violation.hpp"

namespace floeplan::problems {

/// An error response to a request (RFC 9457). Only the catalogue makes them (problem_catalogue.hpp).
struct Problem {
  int status{500};
  std::string slug;    // stable end of the type URI /problems/<slug>; or a whole URI that a standard defines
  std::string title;   // equal for all occurrences
  std::string detail;  // for the user; programs must not parse it; contains no internals
  core::Violations violations{};

  [[nodiscard]] Problem with(core::Violations faults) && {
    violations = std::move(faults);
    return std::move(*this);
  }
};

}  // namespace floeplan::problems

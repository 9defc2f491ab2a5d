#pragma once

#include <string>
#include <utility>

#include "engine/core/violation.hpp"

namespace floeplan::problems {

/// What went wrong with a request (RFC 9457). Made by the catalogue alone (problem_catalogue.hpp).
struct Problem {
  int status{500};
  std::string slug;  // stable, ends the type URI: /problems/<slug>; or a whole URI where a standard names one
  std::string title;   // the same for every occurrence
  std::string detail;  // for a person; nobody parses it, no internals in it
  core::Violations violations{};

  [[nodiscard]] Problem with(core::Violations faults) && {
    violations = std::move(faults);
    return std::move(*this);
  }
};

}  // namespace floeplan::problems

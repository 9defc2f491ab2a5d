#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/core/violation.hpp"

namespace floeplan::codec {

/// What went wrong with a request (RFC 9457).
struct Problem {
  int status{500};
  std::string slug;  // stable, ends the type URI: /problems/<slug>; or a whole URI where a standard names one
  std::string title;   // the same for every occurrence
  std::string detail;  // for a person; nobody parses it, no internals in it
  core::Violations violations;
};

/// Its texts may hold what a client sent: long words are cut to their beginning, and credentials are hidden.
[[nodiscard]] nlohmann::json to_json(const Problem& problem);

}  // namespace floeplan::codec

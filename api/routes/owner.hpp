#pragma once

#include <string>

#include "api/routes/message.hpp"

namespace floeplan::routes {

/// Whose jobs and keys those of the request are; empty: a server that knows nobody by name.
[[nodiscard]] inline std::string owner_of(const Request& request) {
  const bool is_known = request.caller && request.caller->name != local_caller.name;
  return is_known ? request.caller->name : std::string{};
}

}  // namespace floeplan::routes

#pragma once

#include <string>

#include "api/routes/message.hpp"

namespace floeplan::routes {

/// Whose jobs and keys those of the request are; empty: a server that knows nobody by name.
[[nodiscard]] inline std::string owner_of(const Request&) { return {}; }

}  // namespace floeplan::routes

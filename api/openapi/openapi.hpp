#pragma once

#include <string_view>

namespace floeplan::openapi {

/// The OpenAPI document of the service as JSON text, with a placeholder for the server's address.
[[nodiscard]] std::string_view document();

}  // namespace floeplan::openapi

#pragma once

#include <string>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// The absolute link to another page: the request's own URL with one query parameter replaced.
[[nodiscard]] std::string address_with(const Request& request, const std::string& public_url,
                                       const std::string& parameter, const std::string& value);

/// The request's own URL.
[[nodiscard]] std::string address_of(const Request& request, const std::string& public_url);

}  // namespace floeplan::routes

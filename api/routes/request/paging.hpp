#pragma once

#include <string>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// The request's own address with one query parameter replaced: the absolute link to another page.
[[nodiscard]] std::string address_with(const Request& request, const std::string& public_url,
                                       const std::string& parameter, const std::string& value);

/// The request's own address.
[[nodiscard]] std::string address_of(const Request& request, const std::string& public_url);

}  // namespace floeplan::routes

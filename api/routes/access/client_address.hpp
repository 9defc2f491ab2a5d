#pragma once

#include <string>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// The address of the client behind a proxy of ours: it adds it to the end of X-Forwarded-For, and what stands before came
/// from outside. The peer's where there is no such header.
[[nodiscard]] std::string address_behind_proxy(const Request& request);

}  // namespace floeplan::routes

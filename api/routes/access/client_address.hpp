#pragma once

#include <string>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// The address of the client behind the operator's proxy: the last entry of X-Forwarded-For, which the proxy
/// adds. Earlier entries come from outside and are not trusted. Without this header, the address of the peer.
[[nodiscard]] std::string address_behind_proxy(const Request& request);

}  // namespace floeplan::routes

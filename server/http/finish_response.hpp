#pragma once

#include "api/routes/request/message.hpp"

namespace floeplan::http {

/// Adds what every response needs whatever it is about: security headers, ETag and 304, gzip with Vary.
/// The body of a HEAD response is kept: the session leaves it out and keeps its length.
[[nodiscard]] routes::Response finish_response(const routes::Request& request, routes::Response response);

}  // namespace floeplan::http

#pragma once

#include "api/routes/request/message.hpp"

namespace floeplan::http {

/// Adds what every response needs: security headers, ETag and 304, gzip with Vary. The body of a response to
/// HEAD is kept; the session sends only its length.
[[nodiscard]] routes::Response finish_response(const routes::Request& request, routes::Response response);

}  // namespace floeplan::http

#pragma once

#include <optional>
#include <string>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// The credential in a request.
struct ShownCredential {
  std::string text;
  bool by_cookie{false};  // from the cookie of a login, which the browser sends by itself
};

/// The credential of a request: from the Authorization header (scheme Bearer); for POST /session also from
/// the member "token" of the body; otherwise from the cookie of a login. nullopt if there is none. Never from
/// the URL, which logs and browser histories store.
[[nodiscard]] std::optional<ShownCredential> shown_credential(const Request& request);

/// The Set-Cookie header of a login that is valid for `seconds`. With an empty text and 0 seconds the header
/// logs the user out.
[[nodiscard]] std::string login_cookie(const std::string& text, int seconds, bool secure);

}  // namespace floeplan::routes

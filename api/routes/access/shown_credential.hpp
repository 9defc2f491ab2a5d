#pragma once

#include <optional>
#include <string>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// What a request shows to prove who asks.
struct ShownCredential {
  std::string text;
  bool by_cookie{false};  // of a login, which the browser adds by itself
};

/// The credential of a request: from the Authorization header (scheme Bearer); for POST /session also from the member
/// "token" of the body; otherwise from the cookie of a login. Nothing when there is none of them. Never from the
/// address, which logs and histories keep.
[[nodiscard]] std::optional<ShownCredential> shown_credential(const Request& request);

/// The Set-Cookie header that logs in for `seconds`; with no text and 0 seconds, the one that logs out.
[[nodiscard]] std::string login_cookie(const std::string& text, int seconds, bool secure);

}  // namespace floeplan::routes

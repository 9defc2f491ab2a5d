#pragma once

#include <optional>
#include <string>

namespace floeplan::routes {

/// True when an Accept header names HTML and ranks it at least as high as JSON. "*/*" alone is no wish for
/// HTML.
[[nodiscard]] bool prefers_html(const std::string& accept);

/// What a client wishes by the Prefer header (RFC 7240).
struct Preferences {
  bool respond_sync{false};
  bool respond_async{false};
  std::optional<int> wait_s;
};
[[nodiscard]] Preferences parse_prefer(const std::string& prefer);

}  // namespace floeplan::routes

#pragma once

#include <optional>
#include <string>

namespace floeplan::routes {

/// True if an Accept header names HTML with at least the rank of JSON. "*/*" does not count as a wish for
/// HTML.
[[nodiscard]] bool prefers_html(const std::string& accept);

/// The preferences of a client in the Prefer header (RFC 7240).
struct Preferences {
  bool respond_sync{false};
  bool respond_async{false};
  std::optional<int> wait_s;
};
[[nodiscard]] Preferences parse_prefer(const std::string& prefer);

}  // namespace floeplan::routes

#pragma once

#include <string>
#include <string_view>

namespace floeplan::routes {

/// Host and port of a URL or origin: "map.example:8443" in "https://map.example:8443/a". Empty if it has
/// none.
[[nodiscard]] std::string authority_of(std::string_view url);

/// Whether a Host header names a domain whose owner could direct the name to this machine, so that pages of
/// the domain could use a server meant for this machine only (DNS rebinding). False for addresses,
/// "localhost", names without a dot, and `own`, the server's name.
[[nodiscard]] bool could_be_rebound(std::string_view host_header, std::string_view own);

/// Whether the text is an origin in the form of browsers: scheme, host and optionally a port.
[[nodiscard]] bool is_origin(std::string_view text);

}  // namespace floeplan::routes

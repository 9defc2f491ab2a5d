#pragma once

#include <string>
#include <string_view>

namespace floeplan::routes {

/// Host and port of a URL or origin: "map.example:8443" of "https://map.example:8443/a". Empty when it has none.
[[nodiscard]] std::string authority_of(std::string_view url);

/// Whether a Host header names a site whose owner could have made the name point at this machine, to have his page take
/// part in what this machine alone may do. Addresses, "localhost" and names without a dot belong to nobody outside, and
/// `own` is the server's.
[[nodiscard]] bool could_be_rebound(std::string_view host_header, std::string_view own);

/// Whether the text is an origin as browsers write it: scheme, host and perhaps a port, nothing after them.
[[nodiscard]] bool is_origin(std::string_view text);

}  // namespace floeplan::routes

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace floeplan::http {

/// Where to listen.
struct ListenAddress {
  std::string host;  // an IP address, without brackets
  std::uint16_t port{};
};

/// Reads "127.0.0.1:8080", "[::1]:8080" or "localhost:8080".
/// Errors  why it is refused, for a person: not an address, or not of this machine alone. Nobody proves who
/// they are yet,
///         so whoever reaches the port may do anything
[[nodiscard]] tl::expected<ListenAddress, std::string> parse_listen_address(std::string_view text);

}  // namespace floeplan::http

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace floeplan::http {

/// The address on which the server listens.
struct ListenAddress {
  std::string host;  // an IP address, without brackets
  std::uint16_t port{};
  bool loopback{true};  // only this machine can reach it
};

/// Parses "127.0.0.1:8080", "[::1]:8080" or "localhost:8080".
/// Errors   why the text is not such an address, for the user
[[nodiscard]] tl::expected<ListenAddress, std::string> parse_listen_address(std::string_view text);

}  // namespace floeplan::http

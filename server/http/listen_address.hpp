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
  bool loopback{true};  // nobody but this machine reaches it
};

/// Reads "127.0.0.1:8080", "[::1]:8080" or "localhost:8080".
/// Errors   why it is none, for a person
[[nodiscard]] tl::expected<ListenAddress, std::string> parse_listen_address(std::string_view text);

}  // namespace floeplan::http

#include "server/http/listen_address.hpp"

#include <boost/asio/ip/address.hpp>
#include <charconv>

#include "engine/messages/command_messages.hpp"

namespace floeplan::http {

tl::expected<ListenAddress, std::string> parse_listen_address(std::string_view text) {
  const auto colon = text.rfind(':');
  std::string_view host = colon == std::string_view::npos ? std::string_view{} : text.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);

  ListenAddress address{host == "localhost" ? "127.0.0.1" : std::string{host}, 0};
  const std::string_view digits =
      colon == std::string_view::npos ? std::string_view{} : text.substr(colon + 1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), address.port);
  boost::system::error_code not_an_address;
  const auto ip = boost::asio::ip::make_address(address.host, not_an_address);
  if (not_an_address || error != std::errc{} || end != digits.data() + digits.size()) {
    return tl::unexpected(messages::command_text<"wrong-listen-address">(text));
  }
  address.loopback = ip.is_loopback();
  return address;
}

}  // namespace floeplan::http

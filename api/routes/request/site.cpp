#include "api/routes/request/site.hpp"

namespace floeplan::routes {
namespace {

std::string_view without_port(std::string_view authority) {
  const auto colon = authority.rfind(':');
  return colon == std::string_view::npos ? authority : authority.substr(0, colon);
}

}  // namespace

std::string authority_of(std::string_view url) {
  const auto scheme = url.find("://");
  if (scheme == std::string_view::npos) return {};
  const std::string_view rest = url.substr(scheme + 3);
  return std::string{rest.substr(0, rest.find_first_of("/?#"))};
}

bool could_be_rebound(std::string_view host_header, std::string_view own) {
  if (host_header.empty() || host_header == own || host_header.starts_with('[')) return false;
  const std::string_view host = without_port(host_header);
  const bool is_address = host.find_first_not_of("0123456789.") == std::string_view::npos;
  const bool has_dot = host.find('.') != std::string_view::npos;
  return has_dot && !is_address && !host.ends_with(".localhost") && host != without_port(own);
}

bool is_origin(std::string_view text) {
  constexpr const char* allowed =
      "abcdefghijklmnopqrstuvwxyz0123456789.-:[]";  // names in lower case, addresses, ports
  const bool known = text.starts_with("http://") || text.starts_with("https://");
  const std::string authority = authority_of(text);
  return known && !authority.empty() && text.ends_with("://" + authority) &&
         authority.find_first_not_of(allowed) == std::string::npos;
}

}  // namespace floeplan::routes

#include "api/routes/request/paging.hpp"

#include <string_view>

namespace floeplan::routes {
namespace {

/// Percent-encodes all characters except letters, digits and those in `kept`.
std::string encoded(std::string_view text, std::string_view kept) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string result;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       kept.find(c) != std::string_view::npos;
    if (plain) {
      result += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      result += '%';
      result += digits[byte >> 4U];
      result += digits[byte & 15U];
    }
  }
  return result;
}

std::string address(const Request& request, const std::string& public_url,
                    const std::vector<std::pair<std::string, std::string>>& query) {
  std::string result = public_url + encoded(request.path, "-._~/");
  char separator = '?';
  for (const auto& [name, value] : query) {
    result += separator + encoded(name, "-._~") + "=" + encoded(value, "-._~,:");
    separator = '&';
  }
  return result;
}

}  // namespace

std::string address_of(const Request& request, const std::string& public_url) {
  return address(request, public_url, request.query);
}

std::string address_with(const Request& request, const std::string& public_url, const std::string& parameter,
                         const std::string& value) {
  auto query = request.query;
  std::erase_if(query, [&](const auto& pair) { return pair.first == parameter; });
  query.emplace_back(parameter, value);
  return address(request, public_url, query);
}

}  // namespace floeplan::routes

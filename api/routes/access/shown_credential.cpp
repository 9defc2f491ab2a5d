#include "api/routes/access/shown_credential.hpp"

#include <string_view>

#include "api/codec/bytes/json_text.hpp"
#include "api/codec/bytes/text_values.hpp"
#include "storage/json/json.hpp"

namespace floeplan::routes {
namespace {

constexpr std::string_view cookie_name = "floeplan_session";

/// Whether the scheme is Bearer; upper and lower case are equal (RFC 9110, 11.1).
bool is_bearer(std::string_view header) {
  constexpr std::string_view scheme = "bearer ";
  if (header.size() < scheme.size()) return false;
  for (std::size_t i = 0; i < scheme.size(); ++i) {
    const char c = header[i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != scheme[i]) return false;
  }
  return true;
}

std::optional<std::string> cookie_of(std::string_view header) {
  while (!header.empty()) {
    const auto end = std::min(header.find(';'), header.size());
    const std::string_view pair = codec::trimmed(header.substr(0, end));
    header.remove_prefix(std::min(end + 1, header.size()));
    if (pair.starts_with(cookie_name) && pair.substr(cookie_name.size()).starts_with('='))
      return std::string{pair.substr(cookie_name.size() + 1)};
  }
  return std::nullopt;
}

std::optional<std::string> token_of_body(const Request& request) {
  if (request.method != "POST" || request.path != "/session" || request.body.empty()) return std::nullopt;
  const auto body = codec::parse_json(request.body);
  if (!body || !body->is_object()) return std::nullopt;
  const auto token = body->find("token");
  if (token == body->end() || !token->is_string()) return std::nullopt;
  return token->get<std::string>();
}

}  // namespace

std::optional<ShownCredential> shown_credential(const Request& request) {
  const std::string authorization = request.header("authorization");
  if (is_bearer(authorization))
    return ShownCredential{std::string{codec::trimmed(std::string_view{authorization}.substr(7))}, false};
  if (!authorization.empty()) return ShownCredential{};  // another scheme: an invalid credential
  if (auto token = token_of_body(request)) return ShownCredential{std::move(*token), false};
  if (auto cookie = cookie_of(request.header("cookie"))) return ShownCredential{std::move(*cookie), true};
  return std::nullopt;
}

std::string login_cookie(const std::string& text, int seconds, bool secure) {
  return std::string{cookie_name} + "=" + text +
         "; Path=/; HttpOnly; SameSite=Strict; Max-Age=" + std::to_string(seconds) +
         (secure ? "; Secure" : "");
}

}  // namespace floeplan::routes

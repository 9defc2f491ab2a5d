#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "api/codec/bytes/credential.hpp"
#include "api/codec/bytes/multipart.hpp"
#include "api/routes/access/shown_credential.hpp"
#include "api/routes/request/message.hpp"
#include "api/routes/request/preferences.hpp"
#include "api/routes/request/site.hpp"
#include "server/http/strict_head.hpp"

namespace {

using namespace floeplan;

void expect(bool held) {
  if (!held) std::abort();
}

/// An accepted target contains no NUL, and its parts come from the text.
void check_target(std::string_view text) {
  const auto target = routes::parse_target(text);
  if (!target) return;
  expect(target->path.find('\0') == std::string::npos);
  std::size_t length = target->path.size();
  for (const auto& [name, value] : target->query) length += name.size() + value.size();
  expect(length <= text.size());
}

/// An accepted credential is written with the same text.
void check_credential(std::string_view text) {
  const auto credential = codec::parse_credential(text);
  if (credential) expect(codec::credential_text(*credential) == text);
}

/// An accepted origin is a single word that can be in a header.
void check_site(std::string_view text) {
  if (routes::is_origin(text)) expect(text.find_first_of(" \r\n,") == std::string_view::npos);
  static_cast<void>(routes::could_be_rebound(text, "127.0.0.1:8080"));
}

void check_headers(const std::string& text) {
  static_cast<void>(routes::parse_prefer(text));
  static_cast<void>(routes::prefers_html(text));
  routes::Request request;
  request.method = "POST";
  request.path = "/session";
  request.headers = {{"cookie", text}};
  request.body = text;
  const auto shown = routes::shown_credential(request);
  if (shown) expect(shown->text.size() <= text.size() || !shown->by_cookie);
  request.headers = {{"authorization", text}};
  static_cast<void>(routes::shown_credential(request));
}

/// The first line is the content type. The parts are inside the body, one after the other.
void check_multipart(std::string_view text) {
  const auto end = text.find('\n');
  if (end == std::string_view::npos) return;
  const auto parts = codec::parse_multipart(text.substr(0, end), text.substr(end + 1));
  if (!parts) return;
  std::size_t length = 0;
  for (const auto& part : *parts) length += part.content.size();
  expect(length <= text.size());
}

/// The result for a header (accepted, faulty or unfinished) does not depend on whether its bytes come
/// together or singly.
void check_head(std::string_view text) {
  http::StrictHead at_once;
  const auto found = at_once.look_at(text);
  http::StrictHead by_bytes;
  auto so_far = http::StrictHead::State::incomplete;
  for (std::size_t length = 1; length <= text.size() && so_far == http::StrictHead::State::incomplete;
       ++length)
    so_far = by_bytes.look_at(text.substr(0, length));
  expect(so_far == found);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text{reinterpret_cast<const char*>(data), size};
  check_target(text);
  check_credential(text);
  check_site(text);
  check_headers(text);
  check_multipart(text);
  check_head(text);
  return 0;
}

#include "server/http/finish_response.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "server/http/entity_tag.hpp"
#include "server/http/gzip.hpp"

namespace floeplan::http {
namespace {

using routes::Request;
using routes::Response;

constexpr std::size_t least_worth_compressing = 1024;
constexpr const char* content_security_policy =
    "default-src 'self'; img-src 'self' data: blob:; style-src 'self'; object-src 'none'; base-uri 'none'; "
    "frame-ancestors 'none'";

bool has_header(const Response& response, std::string_view name) {
  return std::any_of(response.headers.begin(), response.headers.end(),
                     [&](const auto& header) { return header.first == name; });
}

bool is_compressible(const std::string& type) {
  return type.starts_with("text/") || type.find("json") != std::string::npos ||
         type.find("xml") != std::string::npos || type.starts_with("application/octet-stream") ||
         type.starts_with("application/wasm");
}

/// True when Accept-Encoding names gzip (or "*") and does not forbid it by q=0.
bool accepts_gzip(const std::string& accept_encoding) {
  for (const std::string_view name : {"gzip", "*"}) {
    const auto found = accept_encoding.find(name);
    if (found == std::string::npos) continue;
    const auto end = std::min(accept_encoding.find(',', found), accept_encoding.size());
    std::string parameters = accept_encoding.substr(found + name.size(), end - found - name.size());
    std::erase(parameters, ' ');
    return parameters != ";q=0" && !parameters.starts_with(";q=0.0");
  }
  return false;
}

/// The tag that the resource has given itself, without its quotes.
std::optional<std::string> take_tag(Response& response) {
  const auto found = std::find_if(response.headers.begin(), response.headers.end(),
                                  [](const auto& header) { return header.first == "ETag"; });
  if (found == response.headers.end()) return std::nullopt;
  std::string tag = found->second.substr(1, found->second.size() - 2);
  response.headers.erase(found);
  return tag;
}

bool matches(const std::string& if_none_match, const std::string& tag) {
  return if_none_match == "*" || if_none_match.find('"' + tag) != std::string::npos;
}

}  // namespace

Response finish_response(const Request& request, Response response) {
  if (response.wait && !response.streams) return response;

  response.headers.emplace_back("X-Content-Type-Options", "nosniff");
  response.headers.emplace_back("X-Frame-Options", "DENY");
  response.headers.emplace_back("Referrer-Policy",
                                "same-origin");  // "no-referrer" would take Origin from forms, too
  if (response.content_type.starts_with("text/html")) {
    response.headers.emplace_back("Content-Security-Policy", content_security_policy);
  }
  if (response.streams) return response;
  const bool readable = request.method == "GET" || request.method == "HEAD";
  const bool tagged = readable && response.status == 200;
  const bool compressible =
      response.body.size() > least_worth_compressing && is_compressible(response.content_type);
  const bool compressed = compressible && accepts_gzip(request.header("accept-encoding"));
  if (compressible) routes::vary_by(response, "Accept-Encoding");
  if (tagged) {
    const auto own = take_tag(response);
    const std::string tag = own ? *own : entity_tag(response.body);  // before compression
    response.headers.emplace_back("ETag", '"' + tag + (compressed ? "-gzip\"" : "\""));
    if (!has_header(response, "Cache-Control")) response.headers.emplace_back("Cache-Control", "no-cache");
    if (matches(request.header("if-none-match"), tag)) {
      response.status = 304;
      response.content_type.clear();
      response.body.clear();
      return response;
    }
  }
  if (compressed) {
    response.body = gzip(response.body);
    response.headers.emplace_back("Content-Encoding", "gzip");
  }
  return response;
}

}  // namespace floeplan::http

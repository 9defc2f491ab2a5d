#include "server/http/finish_response.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace floeplan::http {
namespace {

/// The bytes in gzip format (RFC 1952), without a time stamp, so that equal input gives equal output.
std::string gzip(std::string_view bytes) {
  constexpr int window_bits_for_gzip = 15 + 16;
  constexpr int memory_level = 8;
  constexpr int fast = 3;  // answers are compressed for a single request, so speed matters more than size
  z_stream stream{};
  if (deflateInit2(&stream, fast, Z_DEFLATED, window_bits_for_gzip, memory_level, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::runtime_error{"gzip could not begin"};
  }
  std::string result(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  std::string input{bytes};  // zlib's interface takes no const pointer
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int status = deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::runtime_error{"gzip could not end"};
  return result;
}

/// A digest of the bytes as hexadecimal digits: equal for equal bytes, and in practice different for
/// different ones.
std::string entity_tag(std::string_view bytes) {
  constexpr std::size_t length = 16;  // bytes of the SHA-256 that are used
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error{"the cryptographic library has no SHA-256"};
  }
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < length; ++i) {
    text += digits[digest[i] >> 4U];
    text += digits[digest[i] & 15U];
  }
  return text;
}

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

/// Removes and returns the tag that the resource has set, without quotes.
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
                                // "no-referrer" would also suppress the Origin header of forms
                                "same-origin");
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
    const std::string tag = own ? *own : entity_tag(response.body);  // computed before compression
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

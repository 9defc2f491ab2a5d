#include "server/http/request_head.hpp"

#include <boost/beast/core/string.hpp>
#include <string_view>

#include "engine/core/letter_case.hpp"

namespace floeplan::http {
namespace beast = boost::beast;

std::optional<routes::Request> to_request(const beast::http::request_header<>& message) {
  const auto target = message.target();
  auto parsed = routes::parse_target({target.data(), target.size()});
  if (!parsed) return std::nullopt;
  routes::Request request;
  request.method = std::string{message.method_string()};
  request.path = std::move(parsed->path);
  request.query = std::move(parsed->query);
  for (const auto& field : message) {
    const auto name = field.name_string();
    std::string& value = request.headers[core::lower_case({name.data(), name.size()})];
    if (!value.empty()) value += field.name() == beast::http::field::cookie ? "; " : ", ";  // RFC 9110, 5.3
    value += std::string{field.value()};
  }
  return request;
}

bool is_unambiguous(const beast::http::request_header<>& message) {
  using beast::http::field;
  const auto hosts = message.count(field::host);
  const bool coded = message.count(field::transfer_encoding) > 0;
  const bool is_chunked = message.count(field::transfer_encoding) == 1 &&
                          beast::iequals(message[field::transfer_encoding], "chunked");
  const auto length = message[field::content_length];  // "5, 5" is read as 5 by some
  const bool is_number = length.find_first_not_of("0123456789") == beast::string_view::npos;
  return is_number && (hosts == 1 || (hosts == 0 && message.version() == 10)) &&
         message.count(field::content_length) <= 1 &&
         (!coded || (is_chunked && message.count(field::content_length) == 0));
}

}  // namespace floeplan::http

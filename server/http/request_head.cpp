#include "server/http/request_head.hpp"

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

bool names_one_host(const beast::http::request_header<>& message) {
  const auto hosts = message.count(beast::http::field::host);
  return hosts == 1 || (hosts == 0 && message.version() == 10);
}

}  // namespace floeplan::http

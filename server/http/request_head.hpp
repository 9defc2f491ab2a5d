#pragma once

#include <boost/beast/http/message.hpp>
#include <optional>

#include "api/routes/request/message.hpp"

namespace floeplan::http {

/// The header as a request without its body. Headers that come several times are joined to one list (RFC 9110, 5.3).
/// Nothing when the target is not valid.
[[nodiscard]] std::optional<routes::Request> to_request(const boost::beast::http::request_header<>& message);

/// HTTP/1.1 asks for the name of the host, once (RFC 9112, 3.2).
[[nodiscard]] bool names_one_host(const boost::beast::http::request_header<>& message);

}  // namespace floeplan::http

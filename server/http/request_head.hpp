#pragma once

#include <boost/beast/http/message.hpp>
#include <optional>

#include "api/routes/request/message.hpp"

namespace floeplan::http {

/// The header as a request without body. A repeated header is joined to one list (RFC 9110, 5.3). nullopt if
/// the target is invalid.
[[nodiscard]] std::optional<routes::Request> to_request(const boost::beast::http::request_header<>& message);

/// Whether the request has exactly one Host header, as HTTP/1.1 requires (RFC 9112, 3.2).
[[nodiscard]] bool names_one_host(const boost::beast::http::request_header<>& message);

}  // namespace floeplan::http

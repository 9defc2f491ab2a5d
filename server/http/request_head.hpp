#pragma once

#include <boost/beast/http/message.hpp>
#include <optional>

#include "api/routes/message.hpp"

namespace floeplan::http {

/// The header as a request without its body. Headers that come several times are joined to one list (RFC 9110, 5.3).
/// Nothing when the target is not valid.
[[nodiscard]] std::optional<routes::Request> to_request(const boost::beast::http::request_header<>& message);

/// What must hold of a header before a body may be looked for: readings of it that differ from one server to the next
/// let a request hide in another (RFC 9112, 3.2 and 6.1).
[[nodiscard]] bool is_unambiguous(const boost::beast::http::request_header<>& message);

}  // namespace floeplan::http

#pragma once

#include <boost/beast/core/error.hpp>
#include <cstdint>
#include <optional>

#include "api/problems/problem_catalogue.hpp"
#include "api/routes/request/message.hpp"

namespace floeplan::http {

/// The response for a problem (RFC 9457) outside of any resource. Its texts are this program's own and need
/// no escaping.
[[nodiscard]] routes::Response problem_response(const problems::Problem& problem);

/// The response if all memory for requests is in use: 503, try again.
[[nodiscard]] routes::Response busy();
/// The error of a body for which there is no memory.
[[nodiscard]] boost::beast::error_code no_memory();

/// The response to a request that could not be received; nullopt if the client cannot get one.
/// `in_first_line`  the fault is in the request line
/// `most_bytes`     limit of the body
[[nodiscard]] std::optional<routes::Response> refusal_of(boost::beast::error_code fault, bool in_first_line,
                                                         std::uint64_t most_bytes);

}  // namespace floeplan::http

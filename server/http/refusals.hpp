#pragma once

#include <boost/beast/core/error.hpp>
#include <cstdint>
#include <optional>

#include "api/problems/problem_catalogue.hpp"
#include "api/routes/request/message.hpp"

namespace floeplan::http {

/// A problem (RFC 9457) that no resource has said; the texts are ours and need no escaping.
[[nodiscard]] routes::Response problem_response(const problems::Problem& problem);

/// All memory that requests may take is taken: 503, come again.
[[nodiscard]] routes::Response busy();
/// The fault of a body for which there is no memory.
[[nodiscard]] boost::beast::error_code no_memory();

/// What to say of a request that could not be received; nothing when there is nobody to tell.
/// `in_first_line`  not even the line with the address had ended
/// `most_bytes`     that a body could have had
[[nodiscard]] std::optional<routes::Response> refusal_of(boost::beast::error_code fault, bool in_first_line,
                                                         std::uint64_t most_bytes);

}  // namespace floeplan::http

#include "server/http/refusals.hpp"

#include <boost/beast/http/error.hpp>

#include "server/http/finish_response.hpp"

namespace floeplan::http {

using boost::beast::error_code;
using routes::Response;

Response problem(int status, const std::string& slug, const std::string& title, const std::string& detail) {
  Response response;
  response.status = status;
  response.content_type = "application/problem+json";
  response.body = R"({"type":"/problems/)" + slug + R"(","title":")" + title + R"(","status":)" +
                  std::to_string(status) + R"(,"detail":")" + detail + R"("})";
  return finish_response({}, std::move(response));
}

Response busy() {
  Response response =
      problem(503, "busy", "Busy",
              "The server holds all the memory that requests may take; send it again in a moment.");
  response.headers.emplace_back("Retry-After", "5");
  return response;
}

error_code no_memory() { return make_error_code(boost::system::errc::not_enough_memory); }

std::optional<Response> refusal_of(error_code fault, bool in_first_line, std::uint64_t most_bytes) {
  using boost::beast::http::error;
  if (fault == no_memory()) return busy();
  if (fault.category() == boost::system::generic_category())
    return problem(507, "insufficient-storage", "Insufficient storage",
                   "The server cannot write the body to its disk.");
  const bool is_of_http = fault.category() == make_error_code(error::end_of_stream).category();
  if (!is_of_http || fault == error::end_of_stream || fault == error::partial_message) return std::nullopt;
  if (fault == error::header_limit && in_first_line)
    return problem(414, "target-too-long", "Target too long", "The address is longer than 16 KiB.");
  if (fault == error::header_limit)
    return problem(431, "header-too-large", "Header too large", "The header is larger than 16 KiB.");
  if (fault == error::body_limit)
    return problem(413, "body-too-large", "Body too large",
                   "The body is larger than " + std::to_string(most_bytes >> 20U) + " MiB.");
  return problem(400, "invalid-request", "Invalid request", "The request is not valid HTTP/1.1.");
}

}  // namespace floeplan::http

#include "server/http/refusals.hpp"

#include <boost/beast/http/error.hpp>

#include "server/http/finish_response.hpp"

namespace floeplan::http {

using boost::beast::error_code;
using routes::Response;

Response problem_response(const problems::Problem& problem) {
  Response response;
  response.status = problem.status;
  response.content_type = "application/problem+json";
  response.body = R"({"type":"/problems/)" + problem.slug + R"(","title":")" + problem.title +
                  R"(","status":)" + std::to_string(problem.status) + R"(,"detail":")" + problem.detail +
                  R"("})";
  return finish_response({}, std::move(response));
}

Response busy() {
  Response response = problem_response(problems::problem<"busy">());
  response.headers.emplace_back("Retry-After", "5");
  return response;
}

error_code no_memory() { return make_error_code(boost::system::errc::not_enough_memory); }

std::optional<Response> refusal_of(error_code fault, bool in_first_line, std::uint64_t most_bytes) {
  using boost::beast::http::error;
  if (fault == no_memory()) return busy();
  if (fault.category() == boost::system::generic_category())
    return problem_response(problems::problem<"body-not-kept">());
  const bool is_of_http = fault.category() == make_error_code(error::end_of_stream).category();
  if (!is_of_http || fault == error::end_of_stream || fault == error::partial_message) return std::nullopt;
  if (fault == error::header_limit && in_first_line)
    return problem_response(problems::problem<"target-too-long">());
  if (fault == error::header_limit) return problem_response(problems::problem<"header-too-large">());
  if (fault == error::body_limit)
    return problem_response(problems::problem<"body-too-large">(most_bytes >> 20U));
  return problem_response(problems::problem<"invalid-http">());
}

}  // namespace floeplan::http

#include "server/http/finish_response.hpp"

#include <gtest/gtest.h>

#include "server/http/refusals.hpp"

namespace floeplan::http::finish_response_test {
namespace {

using routes::Request;
using routes::Response;

std::string header(const Response& response, const std::string& name) {
  for (const auto& [key, value] : response.headers) {
    if (key == name) return value;
  }
  return {};
}

Request get(std::map<std::string, std::string> headers = {}) {
  Request request;
  request.method = "GET";
  request.headers = std::move(headers);
  return request;
}

Response page(std::size_t size, const std::string& type = "application/json") {
  Response response;
  response.content_type = type;
  response.body.assign(size, 'x');
  return response;
}

TEST(FinishResponse, CompressesLongTextOnlyWhenAsked) {
  const auto plain = finish_response(get(), page(5000));
  const auto packed = finish_response(get({{"accept-encoding", "br, gzip"}}), page(5000));
  const auto refused = finish_response(get({{"accept-encoding", "gzip;q=0"}}), page(5000));
  const auto short_one = finish_response(get({{"accept-encoding", "gzip"}}), page(100));

  EXPECT_EQ(header(plain, "Content-Encoding"), "");
  EXPECT_EQ(header(packed, "Content-Encoding"), "gzip");
  EXPECT_LT(packed.body.size(), 500U);
  EXPECT_EQ(header(packed, "Vary"), "Accept-Encoding");
  EXPECT_EQ(refused.body.size(), 5000U);
  EXPECT_EQ(short_one.body.size(), 100U);
}

TEST(FinishResponse, AnswersNotModifiedForTheTagItGaveCompressedOrNot) {
  const auto first = finish_response(get({{"accept-encoding", "gzip"}}), page(5000));
  const auto second = finish_response(get({{"if-none-match", header(first, "ETag")}}), page(5000));
  const auto other = finish_response(get({{"if-none-match", header(first, "ETag")}}), page(5001));

  EXPECT_EQ(second.status, 304);
  EXPECT_TRUE(second.body.empty());
  EXPECT_EQ(other.status, 200);
}

TEST(FinishResponse, SetsSecurityHeadersOnEveryAnswer) {
  std::vector<Response> answers{
      finish_response(get(), page(10)), finish_response(get({{"if-none-match", "*"}}), page(10)),
      problem_response({.status = 400, .slug = "a", .title = "b", .detail = "c"}), busy()};
  EXPECT_EQ(answers[1].status, 304);
  Response stream = page(10, "text/event-stream");
  stream.streams = true;
  answers.push_back(finish_response(get(), stream));
  Response error = page(10);
  error.status = 404;
  answers.push_back(finish_response(get(), error));
  for (const Response& answer : answers) {
    EXPECT_EQ(header(answer, "X-Content-Type-Options"), "nosniff") << answer.status;
    EXPECT_EQ(header(answer, "X-Frame-Options"), "DENY") << answer.status;
    EXPECT_EQ(header(answer, "Referrer-Policy"), "same-origin") << answer.status;
  }
}

TEST(FinishResponse, TellsPagesWhatTheyMayLoad) {
  const auto html = finish_response(get(), page(10, "text/html; charset=utf-8"));
  EXPECT_EQ(header(html, "X-Content-Type-Options"), "nosniff");
  EXPECT_NE(header(html, "Content-Security-Policy").find("default-src 'self'"), std::string::npos);
  EXPECT_EQ(header(finish_response(get(), page(10)), "Content-Security-Policy"), "");
}

}  // namespace
}  // namespace floeplan::http::finish_response_test

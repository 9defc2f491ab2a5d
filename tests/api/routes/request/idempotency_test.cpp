#include "storage/repository/work/kept_answers.hpp"
#include "tests/api/routes/api_fixture.hpp"

namespace floeplan::routes::idempotency_test {
namespace {

using IdempotencyTest = support::ApiTest;

/// An operation whose answers differ: each has a number.
class Counting : public IdempotencyTest {
 protected:
  Counting() {
    router_ = Router{
        {{"POST", "/things", {"name"}, [this](const Context&, const Request& request, const PathParameters&) {
            Response response;
            response.status = request.body == "bad" ? 400 : 201;
            response.body = std::to_string(++done_);
            response.headers.emplace_back("Location", "/things/" + response.body);
            return response;
          }}}};
  }
  Response post(const std::string& body, const std::string& key, const std::string& target = "/things") {
    return ask("POST", target, body, {{"idempotency-key", key}});
  }

  int done_{0};
};

TEST_F(Counting, DoesARequestOnceAndAnswersItAlike) {
  EXPECT_EQ(post("a", "k1").body, "1");
  const auto again = post("a", "k1");
  EXPECT_EQ(again.body, "1");
  EXPECT_EQ(again.status, 201);
  EXPECT_EQ(support::header_of(again, "Location"), "/things/1");
  EXPECT_EQ(post("a", "k2").body, "2");
  EXPECT_EQ(done_, 2);
}

TEST_F(Counting, RefusesTheKeyOfAnotherRequest) {
  post("a", "k");
  EXPECT_EQ(post("b", "k").status, 409);
  EXPECT_EQ(post("a", "k", "/things?name=other").status, 409);
}

TEST_F(Counting, DoesNotKeepErrors) {
  EXPECT_EQ(post("bad", "k").status, 400);
  EXPECT_EQ(post("good", "k").status, 201);
}

TEST_F(Counting, RefusesKeysThatAreNone) {
  EXPECT_EQ(post("a", "").status, 400);
  EXPECT_EQ(post("a", std::string(256, 'k')).status, 400);
  EXPECT_EQ(post("a", "\x01").status, 400);
}

TEST_F(Counting, ForgetsAKeyAfterADay) {
  post("a", "k");
  repository::KeptAnswers{db_}.remove_expired(last_request_.now + core::Seconds{86'401.0});
  EXPECT_EQ(post("b", "k").status, 201);
}

TEST_F(IdempotencyTest, AnExecutionHandsItsKeyToTheQueue) {
  ask("POST", "/processes/echo/execution", R"({"inputs":{}})", {{"idempotency-key", "k"}});
  ASSERT_TRUE(jobs_.last_submission.key.has_value());
  EXPECT_EQ(jobs_.last_submission.key->key, "k");
}

}  // namespace
}  // namespace floeplan::routes::idempotency_test

#include "api/routes/access/doorkeeper.hpp"

#include "api/codec/bytes/credential.hpp"
#include "storage/repository/access/audit_repository.hpp"
#include "tests/api/routes/api_fixture.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::routes::doorkeeper_test {
namespace {

using Headers = std::map<std::string, std::string>;
using repository::Role;

constexpr core::UtcTime noon{core::Seconds{1.8e9}};

/// The whole API with its access control, on a store in memory.
class DoorsTest : public testing::Test {
 protected:
  explicit DoorsTest(Doors doors = {.open_without_tokens = true, .origins = {"https://map.example"}})
      : keeper_{std::move(doors), Router{all_routes()}} {}

  std::string add_token(const std::string& name, Role role) {
    const codec::Credential credential = codec::new_credential();
    EXPECT_TRUE(repository::TokenRepository{db_}.add({.name = name,
                                                      .role = role,
                                                      .key = credential.key,
                                                      .digest = codec::digest_of(credential),
                                                      .created = noon}));
    return codec::credential_text(credential);
  }

  Response ask(const std::string& method, const std::string& path, Headers headers = {},
               const std::string& body = "") {
    Request request;
    request.method = method;
    request.path = path;
    request.headers = std::move(headers);
    request.headers.try_emplace("host", "127.0.0.1:8080");
    request.body = body;
    request.now = now_;
    request.peer = "192.0.2.1";
    return keeper_.answer({db_, jobs_, service_}, request);
  }

  static Headers bearer(const std::string& token) { return {{"authorization", "Bearer " + token}}; }

  /// Name and value of the cookie that a login sets.
  std::string log_in(const std::string& token) {
    const Response response = ask("POST", "/session", {}, R"({"token": ")" + token + "\"}");
    EXPECT_EQ(response.status, 200) << response.body;
    const std::string cookie = support::header_of(response, "Set-Cookie");
    return cookie.substr(0, cookie.find(';'));
  }

  core::UtcTime now_{noon};
  sql::Connection db_{support::empty_store()};
  support::IdleJobs jobs_;
  ServiceInfo service_{"http://127.0.0.1:8080", {}, {}};
  Doorkeeper keeper_;
};

class ClosedDoorsTest : public DoorsTest {
 protected:
  ClosedDoorsTest()
      : DoorsTest{Doors{.open_without_tokens = false, .secure = true, .behind_proxy = true, .origins = {}}} {}
};

TEST_F(DoorsTest, StandOpenWithoutTokens) {
  EXPECT_EQ(ask("GET", "/datasets").status, 200);
  EXPECT_EQ(ask("DELETE", "/datasets/a").status, 404);
  EXPECT_EQ(support::json_of(ask("GET", "/session")).at("name"), "local");
}

TEST_F(DoorsTest, CloseWithTheFirstToken) {
  add_token("ship", Role::viewer);
  const Response refused = ask("GET", "/datasets");
  EXPECT_EQ(refused.status, 401);
  EXPECT_EQ(refused.content_type, "application/problem+json");
  EXPECT_TRUE(support::header_of(refused, "WWW-Authenticate").starts_with("Bearer"));
}

TEST_F(DoorsTest, StayClosedWhenTheLastTokenIsRevoked) {
  const std::string token = add_token("ship", Role::admin);
  EXPECT_TRUE(repository::TokenRepository{db_}.remove("ship"));
  for (const auto& headers : {Headers{}, bearer(token)}) {
    const Response refused = ask("GET", "/datasets", headers);
    EXPECT_EQ(refused.status, 401);
    EXPECT_NE(refused.body.find("floeplan token add"), std::string::npos) << "the way out is named";
  }
  EXPECT_EQ(ask("GET", "/datasets", bearer(add_token("ship", Role::viewer))).status, 200);
}

TEST_F(ClosedDoorsTest, StayShutWithoutTokens) {
  EXPECT_EQ(ask("GET", "/datasets").status, 401);
  EXPECT_EQ(ask("POST", "/session").status, 401);
}

TEST_F(DoorsTest, LetEverybodySeeWhatALoginTakes) {
  add_token("ship", Role::viewer);
  for (const char* path : {"/", "/healthz", "/api", "/conformance"})
    EXPECT_EQ(ask("GET", path).status, 200) << path;
  EXPECT_EQ(ask("GET", "/session").status, 401);
}

TEST_F(DoorsTest, LetEachRoleDoWhatItMay) {
  const auto viewer = bearer(add_token("viewer", Role::viewer));
  const auto pilot = bearer(add_token("pilot", Role::pilot));
  const auto admin = bearer(add_token("admin", Role::admin));

  EXPECT_EQ(ask("GET", "/datasets", viewer).status, 200);
  EXPECT_EQ(ask("DELETE", "/jobs/a", viewer).status, 403);
  EXPECT_EQ(ask("POST", "/processes/plan-route/execution", viewer).status, 403);
  EXPECT_EQ(ask("DELETE", "/jobs/a", pilot).status, 404);
  EXPECT_EQ(ask("DELETE", "/datasets/a", pilot).status, 403);
  EXPECT_EQ(ask("GET", "/audit", pilot).status, 403);
  EXPECT_EQ(ask("DELETE", "/datasets/a", admin).status, 404);
  EXPECT_EQ(ask("GET", "/audit", admin).status, 200);
  EXPECT_EQ(support::json_of(ask("GET", "/session", pilot)),
            (nlohmann::json{{"name", "pilot"}, {"role", "pilot"}}));
}

TEST_F(DoorsTest, RefuseEveryWayToWriteAToken) {
  std::string token = add_token("ship", Role::admin);
  EXPECT_EQ(ask("GET", "/datasets", {{"authorization", token}}).status, 401);
  EXPECT_EQ(ask("GET", "/datasets", {{"authorization", "Basic " + token}}).status, 401);
  EXPECT_EQ(ask("GET", "/datasets", {{"cookie", "floeplan_session=" + token}}).status, 401);
  token.back() = token.back() == '0' ? '1' : '0';
  EXPECT_EQ(ask("GET", "/datasets", bearer(token)).status, 401);
}

TEST_F(DoorsTest, ForgetARevokedToken) {
  const auto ship = bearer(add_token("ship", Role::admin));
  add_token("other", Role::admin);
  EXPECT_EQ(ask("GET", "/datasets", ship).status, 200);
  repository::TokenRepository{db_}.remove("ship");
  EXPECT_EQ(ask("GET", "/datasets", ship).status, 401);
}

TEST_F(DoorsTest, SlowDownGuesses) {
  const auto ship = bearer(add_token("ship", Role::admin));
  const auto other = bearer(add_token("other", Role::admin));
  EXPECT_EQ(ask("GET", "/datasets", ship).status, 200);
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(ask("GET", "/datasets", bearer(codec::credential_text(codec::new_credential()))).status, 401);

  const Response slowed = ask("GET", "/datasets", other);
  EXPECT_EQ(slowed.status, 429);
  EXPECT_EQ(support::header_of(slowed, "Retry-After"), "6");
  EXPECT_EQ(ask("GET", "/datasets", ship).status, 200) << "was right from there before";
  now_ += core::Seconds{6.0};
  EXPECT_EQ(ask("GET", "/datasets", other).status, 200);
}

TEST_F(DoorsTest, WriteDownFailuresOnceForEachAddressWithTheirNumber) {
  std::string wrong = add_token("ship", Role::admin);
  wrong.back() = wrong.back() == '0' ? '1' : '0';
  for (int i = 0; i < 300; ++i) {
    const Response refused = ask("POST", "/session", {}, R"({"token": ")" + wrong + "\"}");
    EXPECT_EQ(refused.status, i < 10 ? 401 : 429);
    EXPECT_EQ(support::header_of(refused, "Retry-After").empty(), i < 10);
  }
  const auto entries = repository::AuditRepository{db_}.list(0, 1000);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[1].action, "log-in-refused");
  EXPECT_EQ(entries[1].caller, "ship") << "whose token was guessed at";
  EXPECT_EQ(entries[1].peer, "192.0.2.1");
  EXPECT_EQ(entries[1].target, "at least 8 times within 10 minutes");
  EXPECT_EQ(entries[0].target, "at least 256 times within 10 minutes") << "that were not looked at";
}

TEST_F(DoorsTest, BoundLoginsAndWhatTheAuditLogSaysOfThem) {
  const std::string token = add_token("ship", Role::pilot);
  int opened = 0;
  for (int i = 0; i < 300; ++i) {
    const Response response = ask("POST", "/session", bearer(token));
    opened += response.status == 200 ? 1 : 0;
    if (response.status == 429) {
      EXPECT_EQ(support::header_of(response, "Retry-After"), "3");
    }
  }
  EXPECT_EQ(opened, 20);
  EXPECT_EQ(ask("GET", "/datasets", bearer(token)).status, 200) << "the token itself goes on";
  EXPECT_EQ(repository::AuditRepository{db_}.list(0, 1000).size(), 2U);
  now_ += core::Seconds{3.0};
  EXPECT_EQ(ask("POST", "/session", bearer(token)).status, 200);
}

TEST_F(DoorsTest, OpenToALoginUntilItEnds) {
  const std::string token = add_token("ship", Role::pilot);
  const std::string cookie = log_in(token);
  EXPECT_EQ(cookie.find(token), std::string::npos) << "the token itself stays with its owner";
  EXPECT_EQ(ask("GET", "/datasets", {{"cookie", cookie}}).status, 200);
  now_ += core::Seconds{13.0 * 3600.0};
  const Response late = ask("GET", "/datasets", {{"cookie", cookie}});
  EXPECT_EQ(late.status, 401);
  EXPECT_NE(support::header_of(late, "Set-Cookie").find("Max-Age=0"), std::string::npos);
  EXPECT_EQ(ask("GET", "/", {{"cookie", cookie}}).status, 200) << "where one logs in again";
}

TEST_F(DoorsTest, CloseBehindALogout) {
  add_token("other", Role::pilot);
  const std::string cookie = log_in(add_token("ship", Role::pilot));
  EXPECT_EQ(ask("DELETE", "/session", {{"cookie", cookie}, {"origin", "http://127.0.0.1:8080"}}).status, 204);
  EXPECT_EQ(ask("GET", "/datasets", {{"cookie", cookie}}).status, 401);
}

TEST_F(DoorsTest, LetALoginChangeThingsFromOurOwnPagesAlone) {
  const std::string cookie = log_in(add_token("ship", Role::pilot));
  const auto remove_from = [&](Headers headers) {
    headers["cookie"] = cookie;
    return ask("DELETE", "/jobs/a", headers).status;
  };
  EXPECT_EQ(remove_from({{"origin", "http://127.0.0.1:8080"}}), 404);
  EXPECT_EQ(remove_from({{"sec-fetch-site", "same-origin"}}), 404);
  EXPECT_EQ(remove_from({{"origin", "https://evil.example"}}), 403);
  EXPECT_EQ(remove_from({{"origin", "null"}}), 403);
  EXPECT_EQ(remove_from({{"sec-fetch-site", "cross-site"}}), 403);
  EXPECT_EQ(remove_from({}), 403);
}

TEST_F(DoorsTest, KeepForeignPagesOutWithoutTokens) {
  EXPECT_EQ(ask("DELETE", "/jobs/a", {{"origin", "https://evil.example"}}).status, 403);
  EXPECT_EQ(ask("DELETE", "/jobs/a", {{"origin", "https://map.example"}}).status, 404);
  EXPECT_EQ(ask("DELETE", "/jobs/a").status, 404) << "scripts name no origin";
  const Headers rebound{{"host", "evil.example:8080"}, {"origin", "http://evil.example:8080"}};
  EXPECT_EQ(ask("GET", "/datasets", rebound).status, 421);
  EXPECT_EQ(ask("DELETE", "/jobs/a", rebound).status, 421);
}

TEST_F(DoorsTest, TellBrowsersWhichSitesMayAsk) {
  const Headers asking{{"origin", "https://map.example"}, {"access-control-request-method", "POST"}};
  const Response leave = ask("OPTIONS", "/processes/plan-route/execution", asking);
  EXPECT_EQ(leave.status, 204);
  EXPECT_EQ(support::header_of(leave, "Access-Control-Allow-Origin"), "https://map.example");
  EXPECT_NE(support::header_of(leave, "Access-Control-Allow-Headers").find("Authorization"),
            std::string::npos);

  const Response read = ask("GET", "/datasets", {{"origin", "https://map.example"}});
  EXPECT_EQ(support::header_of(read, "Access-Control-Allow-Origin"), "https://map.example");
  EXPECT_NE(support::header_of(read, "Vary").find("Origin"), std::string::npos);

  for (const char* other : {"https://evil.example", "https://map.example.evil.example", "null", ""}) {
    const Response silent = ask("GET", "/datasets", {{"origin", other}});
    EXPECT_EQ(support::header_of(silent, "Access-Control-Allow-Origin"), "") << other;
  }
}

TEST_F(ClosedDoorsTest, TakeTheClientsAddressFromTheirProxyAlone) {
  const auto admin = bearer(add_token("admin", Role::admin));
  const auto wrong_from = [&](const std::string& hops) {
    Headers headers = bearer("wrong");
    headers["x-forwarded-for"] = hops;
    return ask("GET", "/datasets", headers).status;
  };
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(wrong_from("198.51.100." + std::to_string(i) + ", 203.0.113.9"), 401);
  EXPECT_EQ(wrong_from("198.51.100.77, 203.0.113.9"), 429);
  EXPECT_EQ(wrong_from("203.0.113.10"), 401);
}

TEST_F(DoorsTest, WriteDownWhoDidWhat) {
  const auto pilot = bearer(add_token("pilot", Role::pilot));
  ask("GET", "/datasets", pilot);
  ask("DELETE", "/jobs/a", pilot);  // a job that does not exist
  log_in(add_token("ship", Role::pilot));

  const auto entries = repository::AuditRepository{db_}.list(0, 10);
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(entries[0].caller, "ship");
  EXPECT_EQ(entries[0].action, "log-in");
  EXPECT_EQ(entries[0].peer, "192.0.2.1");
}

}  // namespace
}  // namespace floeplan::routes::doorkeeper_test

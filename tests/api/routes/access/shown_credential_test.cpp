#include "api/routes/access/shown_credential.hpp"

#include <gtest/gtest.h>

namespace floeplan::routes::shown_credential_test {
namespace {

Request request_with(std::map<std::string, std::string> headers, const std::string& path = "/plans",
                     const std::string& body = "") {
  Request request;
  request.method = "POST";
  request.path = path;
  request.headers = std::move(headers);
  request.body = body;
  return request;
}

TEST(ShownCredential, IsReadFromTheAuthorizationHeaderFirst) {
  const auto shown =
      shown_credential(request_with({{"authorization", "bearer  abc "}, {"cookie", "floeplan_session=def"}},
                                    "/session", R"({"token": "ghi"})"));
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->text, "abc");
  EXPECT_FALSE(shown->by_cookie);
}

TEST(ShownCredential, IsReadFromTheCookieAmongOthers) {
  for (const char* cookies :
       {"floeplan_session=def", "a=b; floeplan_session=def; c=d", "a;floeplan_session=def"}) {
    const auto shown = shown_credential(request_with({{"cookie", cookies}}));
    ASSERT_TRUE(shown) << cookies;
    EXPECT_EQ(shown->text, "def");
    EXPECT_TRUE(shown->by_cookie);
  }
  EXPECT_FALSE(shown_credential(request_with({{"cookie", "xfloeplan_session=def; floeplan_sessions=d"}})));
}

TEST(ShownCredential, IsReadFromTheBodyOfALoginAlone) {
  const std::string body = R"({"token": "ghi"})";
  EXPECT_EQ(shown_credential(request_with({}, "/session", body))->text, "ghi");
  EXPECT_FALSE(shown_credential(request_with({}, "/plans", body)));
  for (const char* other : {"", "[]", "{", R"({"token": 7})", R"("token")"})
    EXPECT_FALSE(shown_credential(request_with({}, "/session", other))) << other;
}

TEST(ShownCredential, OfAnotherSchemeIsShownAndWrong) {
  for (const char* other : {"Basic YTpi", "floeplan_0123", "Bearerabc"})
    EXPECT_EQ(shown_credential(request_with({{"authorization", other}}))->text, "") << other;
  EXPECT_FALSE(shown_credential(request_with({})));
}

TEST(LoginCookie, IsOutOfReachOfScriptsAndOtherSites) {
  EXPECT_EQ(login_cookie("abc", 60, true),
            "floeplan_session=abc; Path=/; HttpOnly; SameSite=Strict; Max-Age=60; Secure");
  EXPECT_EQ(login_cookie("", 0, false), "floeplan_session=; Path=/; HttpOnly; SameSite=Strict; Max-Age=0");
}

}  // namespace
}  // namespace floeplan::routes::shown_credential_test

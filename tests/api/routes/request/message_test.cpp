#include "api/routes/request/message.hpp"

#include <gtest/gtest.h>

#include "api/routes/request/preferences.hpp"

namespace floeplan::routes::message_test {
namespace {

TEST(ParseTarget, DecodesPathAndQueryAndKeepsRepeats) {
  const auto target = parse_target("/a%2Fb?x=1%2C2&y=a+b&x=3");
  ASSERT_TRUE(target.has_value());
  EXPECT_EQ(target->path, "/a/b");
  EXPECT_EQ(target->query.size(), 3U);
  EXPECT_EQ(target->query[1].second, "a b");
}

TEST(ParseTarget, RefusesBrokenPercentSignsAndNul) {
  EXPECT_FALSE(parse_target("/%").has_value());
  EXPECT_FALSE(parse_target("/%4").has_value());
  EXPECT_FALSE(parse_target("/%zz").has_value());
  EXPECT_FALSE(parse_target("/?a=%00").has_value());
}

TEST(Preferences, PreferHtmlOnlyWhenItIsNamedAndNotBelowJson) {
  EXPECT_TRUE(prefers_html("text/html,application/xhtml+xml,application/xml;q=0.9,*/*;q=0.8"));
  EXPECT_FALSE(prefers_html("*/*"));
  EXPECT_FALSE(prefers_html("application/json, text/html;q=0.5"));
  EXPECT_FALSE(prefers_html(""));
}

TEST(Preferences, ReadThePreferHeaderWithStrayBlanks) {
  const auto wishes = parse_prefer(" respond-async , wait=10 ");
  EXPECT_TRUE(wishes.respond_async);
  EXPECT_EQ(wishes.wait_s, 10);
}

TEST(Target, IsNoneWithANulHoweverItIsWritten) {
  using namespace std::string_view_literals;
  EXPECT_FALSE(parse_target("/a\0b"sv));
  EXPECT_FALSE(parse_target("/a?b=\0"sv));
  EXPECT_FALSE(parse_target("/a%00b"));
}

}  // namespace
}  // namespace floeplan::routes::message_test

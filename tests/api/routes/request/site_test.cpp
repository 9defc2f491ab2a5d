#include "api/routes/request/site.hpp"

#include <gtest/gtest.h>

namespace floeplan::routes::site_test {
namespace {

TEST(Authority, IsHostAndPortOfAUrl) {
  EXPECT_EQ(authority_of("https://map.example:8443/a?b"), "map.example:8443");
  EXPECT_EQ(authority_of("http://[::1]:80"), "[::1]:80");
  EXPECT_EQ(authority_of("null"), "");
}

TEST(Rebinding, TakesANameThatSomebodyOutsideCouldOwn) {
  EXPECT_TRUE(could_be_rebound("evil.example", "127.0.0.1:8080"));
  EXPECT_TRUE(could_be_rebound("127.0.0.1.evil.example:8080", "127.0.0.1:8080"));
  EXPECT_TRUE(could_be_rebound("localhost.evil.example", "127.0.0.1:8080"));
}

TEST(Rebinding, IsNotPossibleByAddressesLocalNamesAndOnesOwn) {
  for (const char* host : {"", "127.0.0.1:8080", "192.0.2.7", "[::1]:8080", "localhost:8080", "ship",
                           "a.localhost:1", "plan.example:8080"}) {
    EXPECT_FALSE(could_be_rebound(host, "plan.example:8080")) << host;
  }
}

TEST(Origin, IsSchemeHostAndPortAlone) {
  for (const char* good : {"https://map.example", "http://localhost:5173", "https://[2001:db8::1]:8443"})
    EXPECT_TRUE(is_origin(good)) << good;
  for (const char* bad :
       {"", "*", "map.example", "https://", "https://map.example/", "https://map.example/a",
        "https://Map.example", "ftp://map.example", "https://a@map.example", "https://a b", "https://a\n"}) {
    EXPECT_FALSE(is_origin(bad)) << bad;
  }
}

}  // namespace
}  // namespace floeplan::routes::site_test

#include "server/http/listen_address.hpp"

#include <gtest/gtest.h>

namespace floeplan::http {
namespace {

TEST(ListenAddress, TakesLoopbackInBothFamiliesAndByName) {
  EXPECT_EQ(parse_listen_address("127.0.0.1:8080")->port, 8080);
  EXPECT_EQ(parse_listen_address("[::1]:0")->host, "::1");
  EXPECT_EQ(parse_listen_address("localhost:1")->host, "127.0.0.1");
}

TEST(ListenAddress, RefusesAddressesThatOthersReachAndSaysWhy) {
  const auto address = parse_listen_address("0.0.0.0:8080");
  ASSERT_FALSE(address.has_value());
  EXPECT_NE(address.error().find("access tokens"), std::string::npos);
  EXPECT_FALSE(parse_listen_address("192.168.1.2:8080").has_value());
}

TEST(ListenAddress, RefusesWhatIsNoAddress) {
  for (const char* text :
       {"", "8080", "127.0.0.1", "127.0.0.1:", "127.0.0.1:99999", "host:80", "127.0.0.1:80x"}) {
    EXPECT_FALSE(parse_listen_address(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace floeplan::http

#include "server/http/listen_address.hpp"

#include <gtest/gtest.h>

namespace floeplan::http::listen_address_test {
namespace {

TEST(ListenAddress, TakesLoopbackInBothFamiliesAndByName) {
  EXPECT_EQ(parse_listen_address("127.0.0.1:8080")->port, 8080);
  EXPECT_EQ(parse_listen_address("[::1]:0")->host, "::1");
  EXPECT_EQ(parse_listen_address("localhost:1")->host, "127.0.0.1");
}

TEST(ListenAddress, KnowsWhatOthersReach) {
  EXPECT_TRUE(parse_listen_address("127.0.0.1:8080")->loopback);
  EXPECT_TRUE(parse_listen_address("[::1]:8080")->loopback);
  EXPECT_FALSE(parse_listen_address("0.0.0.0:8080")->loopback);
  EXPECT_FALSE(parse_listen_address("[::]:8080")->loopback);
  EXPECT_FALSE(parse_listen_address("192.168.1.2:8080")->loopback);
}

TEST(ListenAddress, RefusesWhatIsNoAddress) {
  for (const char* text :
       {"", "8080", "127.0.0.1", "127.0.0.1:", "127.0.0.1:99999", "host:80", "127.0.0.1:80x"}) {
    EXPECT_FALSE(parse_listen_address(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace floeplan::http::listen_address_test

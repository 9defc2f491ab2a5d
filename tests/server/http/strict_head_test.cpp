#include "server/http/strict_head.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <random>

#include "tests/server/http/running_server.hpp"
#include "tests/support/property.hpp"

namespace floeplan::http::strict_head_test {
namespace {

using State = StrictHead::State;

const std::string good = "POST /a HTTP/1.1\r\nHost: x\r\nContent-Length: 3\r\nAccept:\t*/*\r\n\r\n";

/// Headers that servers interpret differently, each followed by a request that one of the interpretations
/// would let through.
std::vector<std::string> ambiguous_requests() {
  const std::string begin = "POST /a HTTP/1.1\r\nHost: x\r\n";
  const std::string hidden = "GET /hidden HTTP/1.1\r\nHost: x\r\n\r\n";
  std::vector<std::string> list;
  for (const char* fields : {"X: a\r\n b\r\n",
                             "X: a\r\n\tb\r\n",
                             " X: a\r\n",
                             "Content-Length : 0\r\n",
                             "Content-Length\t: 0\r\n",
                             "Content-Length: 0\nX: a\r\n",
                             "X: a\rContent-Length: 0\r\n",
                             "Content-Length: 0\r\nContent-Length: 0\r\n",
                             "Content-Length: 0\r\nContent-Length: 5\r\n",
                             "Content-Length: 0, 0\r\n",
                             "Content-Length: +0\r\n",
                             "Content-Length: -1\r\n",
                             "Content-Length: 0x0\r\n",
                             "Content-Length:\r\n",
                             "Content-Length: 99999999999999999999\r\n",
                             "Content-Length: 0\r\nTransfer-Encoding: chunked\r\n",
                             "Transfer-Encoding: chunked\r\nContent-Length: 0\r\n",
                             "Transfer-Encoding: gzip, chunked\r\n",
                             "Transfer-Encoding: identity\r\n",
                             "Transfer-Encoding: xchunked\r\n",
                             "Transfer-Encoding: chunked, chunked\r\n",
                             "Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n",
                             "Transfer-Encoding:\x0b chunked\r\n",
                             "Transfer-Encoding : chunked\r\n",
                             "X(a): b\r\n",
                             ": b\r\n",
                             "no colon\r\n"})
    list.push_back(begin + fields + "\r\n" + hidden);
  list.push_back(begin + std::string{"X: a\0b\r\n", 8} + "\r\n" + hidden);
  list.push_back("POST /a HTTP/1.0\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n" + hidden);
  list.push_back("POST /a HTTP/1.1\nHost: x\n\n" + hidden);
  list.push_back("POST /a HTTP/2.0\r\nHost: x\r\n\r\n" + hidden);
  list.push_back("POST\t/a HTTP/1.1\r\nHost: x\r\n\r\n" + hidden);
  for (const char* chunk :
       {"0;a=b\r\n\r\n", "1;\r\na\r\n0\r\n\r\n", "0x1\r\na\r\n0\r\n\r\n", "+1\r\na\r\n0\r\n\r\n",
        "-1\r\na\r\n0\r\n\r\n", "1\na\n0\n\n", "1\r\nab\r\n0\r\n\r\n", "ffffffffffffffffff\r\na",
        "fffffffffffffff0\r\na", " 1\r\na\r\n0\r\n\r\n"})
    list.push_back(begin + "Transfer-Encoding: chunked\r\n\r\n" + chunk + hidden);
  return list;
}

TEST(StrictHead, FindsTheEndHoweverTheBytesCome) {
  support::for_each_seed(100, [](std::mt19937_64& rng) {
    StrictHead head;
    const std::string bytes = good + "abc";
    std::size_t come = 0;
    while (come < good.size()) {
      EXPECT_EQ(head.look_at(std::string_view{bytes}.substr(0, come)), State::incomplete);
      come = std::min(come + 1 + rng() % 20, bytes.size());
    }
    EXPECT_EQ(head.look_at(std::string_view{bytes}.substr(0, come)), State::complete);
  });
}

/// A header with a control character is refused, or it is not complete yet.
TEST(StrictHead, TakesNoControlCharacterAnywhere) {
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const char c : {'\0', '\x01', '\x0b', '\x7f', '\r', '\n'}) {
      std::string bytes = good;
      if (bytes[at] == c) continue;
      bytes[at] = c;
      StrictHead head;
      EXPECT_NE(head.look_at(bytes), State::complete) << at << ' ' << static_cast<int>(c);
    }
  }
}

TEST(StrictFraming, RefusesWhatOthersCouldReadDifferentlyAndEndsTheConnection) {
  for (const std::string& bytes : ambiguous_requests()) {
    std::atomic<int> reached{0};
    const support::RunningServer server{[&reached](const routes::Request& request) {
      ++reached;
      return support::echo(request);
    }};
    const std::string answer = server.exchange(bytes);
    const bool too_large = answer.starts_with("HTTP/1.1 413");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 400") || too_large) << bytes << "\n->\n"
                                                                 << answer.substr(0, 200);
    EXPECT_EQ(answer.find("HTTP/1.1 ", 1), std::string::npos) << "only one answer to\n" << bytes;
    EXPECT_NE(answer.find("Connection: close"), std::string::npos) << bytes;
    EXPECT_EQ(reached, 0) << bytes;
  }
}

TEST(StrictFraming, TakesWhatIsPlain) {
  const support::RunningServer server{support::echo};
  EXPECT_TRUE(server.exchange(good + "abc" + support::get("/2")).ends_with("GET /2 "));
  const std::string chunked = server.exchange(
      "POST /c HTTP/1.1\r\nHost: x\r\nConnection: close\r\nTransfer-Encoding: "
      "Chunked\r\n\r\n3\r\nabc\r\n0\r\n\r\n");
  EXPECT_TRUE(chunked.ends_with("POST /c abc")) << chunked;
  EXPECT_TRUE(server.exchange("GET /0 HTTP/1.0\r\n\r\n").starts_with("HTTP/1.1 200"));
}

}  // namespace
}  // namespace floeplan::http::strict_head_test

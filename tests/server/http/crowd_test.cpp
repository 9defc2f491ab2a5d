#include <gtest/gtest.h>

#include <list>

#include "tests/server/http/running_server.hpp"

namespace floeplan::http::crowd_test {
namespace {

namespace net = boost::asio;
using support::echo;
using support::get;

/// Connections that a test opens and keeps open.
class Crowd {
 public:
  explicit Crowd(const support::RunningServer& server) : server_{server} {}

  /// Opens another connection and sends these bytes.
  net::ip::tcp::socket& join(const std::string& bytes = "") {
    net::ip::tcp::socket& socket = sockets_.emplace_back(io_);
    socket.connect(server_.endpoint());
    boost::system::error_code ignored;
    net::write(socket, net::buffer(bytes), ignored);
    return socket;
  }

 private:
  const support::RunningServer& server_;
  net::io_context io_;
  std::list<net::ip::tcp::socket> sockets_;
};

TEST(Crowd, OfIdleConnectionsMakesRoomForThoseWhoAsk) {
  const support::RunningServer server{echo, {.connections = 20, .connections_per_address = 10}};
  Crowd crowd{server};
  for (int i = 0; i < 100; ++i) crowd.join();
  EXPECT_TRUE(server.exchange(get("/")).starts_with("HTTP/1.1 200"));
}

TEST(Crowd, OfSlowHeadersAndBodiesMakesRoomForThoseWhoAsk) {
  const support::RunningServer server{echo, {.connections = 10, .connections_per_address = 10}};
  Crowd crowd{server};
  for (int i = 0; i < 50; ++i) {
    crowd.join("GET / HTTP/1.1\r\nHost: x\r\nX-Slow: ");
    crowd.join("POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 1000\r\n\r\n{");
  }
  EXPECT_TRUE(server.exchange(get("/")).starts_with("HTTP/1.1 200"));
}

TEST(Crowd, WhoSaysNothingIsSentAway) {
  const support::RunningServer server{echo, {.first_byte_time = std::chrono::seconds{1}}};
  EXPECT_EQ(server.exchange(""), "");
}

TEST(Crowd, MayNotFillTheMemoryWithBodies) {
  const support::RunningServer server{echo, {.held_bytes = 1'000'000}};
  Crowd crowd{server};
  const std::string head = "POST / HTTP/1.1\r\nHost: x\r\nConnection: close\r\nContent-Length: ";
  for (int i = 0; i < 10; ++i) crowd.join(head + "900000\r\n\r\n{");

  const std::string refused = server.exchange(head + "900000\r\n\r\n" + std::string(900'000, 'x'));
  EXPECT_TRUE(refused.starts_with("HTTP/1.1 503")) << refused.substr(0, 200);
  EXPECT_NE(refused.find("Retry-After: "), std::string::npos);
  EXPECT_TRUE(server.exchange(head + "5\r\n\r\nsmall").ends_with("small"));
}

/// A request that a proxy in front of the server may read differently must be refused.
TEST(Smuggling, IsRefused) {
  const support::RunningServer server{echo};
  const std::string post = "POST / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n";
  for (const std::string& request : {
           post + "Content-Length: 5\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
           post + "Transfer-Encoding: chunked\r\nContent-Length: 5\r\n\r\n0\r\n\r\n",
           post + "Content-Length: 5\r\nContent-Length: 6\r\n\r\nhello!",
           post + "Content-Length: 5\r\nContent-Length: 5\r\n\r\nhello",
           post + "Content-Length: 5, 5\r\n\r\nhello",
           post + "Content-Length: +5\r\n\r\nhello",
           post + "Content-Length: -1\r\n\r\n",
           post + "Content-Length: 99999999999999999999\r\n\r\n",
           post + "Transfer-Encoding: identity\r\n\r\nhello",
           post + "Transfer-Encoding: gzip, chunked\r\n\r\n0\r\n\r\n",
           post + "Transfer-Encoding: xchunked\r\n\r\n0\r\n\r\n",
           post + "Transfer-Encoding: chunked\r\nTransfer-Encoding: identity\r\n\r\n0\r\n\r\n",
           post + "Transfer-Encoding : chunked\r\n\r\n0\r\n\r\n",
           post + "Transfer-Encoding: chunked\r\n\r\nzz\r\nhello\r\n0\r\n\r\n",
           post + "Transfer-Encoding: chunked\r\n\r\n5;" + std::string(1'000'000, 'a'),
           post + "X: a\r\n Folded: b\r\nContent Length: 5\r\n\r\nhello",
           std::string{"GET / HTTP/1.1\r\nConnection: close\r\n\r\n"},
           std::string{"GET / HTTP/1.1\r\nHost: x\r\nHost: y\r\nConnection: close\r\n\r\n"},
           std::string{"GET / HTTP/1.1\r\nHost: x\r\nX: a\0b\r\nConnection: close\r\n\r\n", 62},
           std::string{"GET /a b HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n"},
           std::string{"GET / HTTP/2.0\r\nHost: x\r\nConnection: close\r\n\r\n"},
       }) {
    const std::string answer = server.exchange(request);
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 4")) << request << " -> " << answer.substr(0, 200);
    EXPECT_EQ(answer.find("HTTP/1.1 ", 8), std::string::npos) << "one answer, then the end: " << request;
  }
}

TEST(Smuggling, IsNoReasonToRefusePlainBodies) {
  const support::RunningServer server{echo};
  const std::string post = "POST / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n";
  EXPECT_TRUE(server.exchange(post + "Content-Length: 5\r\n\r\nhello").ends_with("hello"));
  EXPECT_TRUE(
      server.exchange(post + "Transfer-Encoding: Chunked\r\n\r\n5\r\nhello\r\n0\r\n\r\n").ends_with("hello"));
  EXPECT_TRUE(server.exchange("GET / HTTP/1.0\r\n\r\n").starts_with("HTTP/1.1 200"));
}

TEST(Header, ThatComesTwiceIsReadAsOneList) {
  const support::RunningServer server{[](const routes::Request& request) {
    routes::Response response;
    response.body = request.header("accept") + "|" + request.header("cookie");
    return response;
  }};
  EXPECT_TRUE(server.exchange(get("/", "Accept: a\r\nCookie: b=1\r\nAccept: c\r\nCookie: d=2\r\n"))
                  .ends_with("a, c|b=1; d=2"));
}

TEST(Header, OfAnAddressThatIsTooLongIsNamed) {
  const support::RunningServer server{echo};
  EXPECT_TRUE(server.exchange(get("/" + std::string(20'000, 'a'))).starts_with("HTTP/1.1 414"));
}

TEST(Observer, HearsOfEveryAnswer) {
  std::string heard;
  {
    const support::RunningServer server{echo, {}, {.observe = [&](const Exchange& exchange) {
                                          heard = exchange.method + std::to_string(exchange.status);
                                        }}};
    EXPECT_NE(server.exchange(get("/")), "");
  }
  EXPECT_EQ(heard, "GET200");
}

}  // namespace
}  // namespace floeplan::http::crowd_test

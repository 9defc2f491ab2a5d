#include <gtest/gtest.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <fstream>
#include <iterator>
#include <thread>

#include "api/codec/bytes/sha256.hpp"
#include "server/http/server.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::http::streamed_body_test {
namespace {

namespace net = boost::asio;

/// A server that streams uploads to /file to disk and answers with the stored content.
class StreamedBody : public testing::Test {
 protected:
  StreamedBody() : thread_{[this] { server_.run(); }} {}
  ~StreamedBody() override {
    server_.stop();
    thread_.join();
  }

  static routes::Response look(const routes::Request& request) {
    routes::Response response;
    response.content_type = "text/plain";
    if (!request.body_file) {
      response.body = "in memory: " + std::to_string(request.body.size());
      return response;
    }
    std::ifstream in{request.body_file->path, std::ios::binary};
    const std::string bytes{std::istreambuf_iterator<char>{in}, {}};
    response.body = std::to_string(bytes.size()) + " " + (request.body.empty() ? "" : "and in memory ") +
                    (codec::sha256(bytes) == request.body_file->sha256 ? "as sent" : "with a wrong digest");
    return response;
  }

  std::string exchange(const std::string& head, const std::string& body) {
    net::io_context io;
    net::ip::tcp::socket socket{io};
    socket.connect({net::ip::make_address("127.0.0.1"), server_.port()});
    boost::system::error_code error;
    net::write(socket, net::buffer(head + "\r\nHost: x\r\nConnection: close\r\n" + body), error);
    std::string answer;
    net::read(socket, net::dynamic_buffer(answer), error);
    return answer;
  }
  static std::string sized(const std::string& body) {
    return "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  }

  support::TemporaryFolder folder_;
  Server server_{{"127.0.0.1", 0},
                 look,
                 2,
                 {},
                 {.streaming = {[](const std::string& method, const std::string& path) {
                                  return method == "POST" && path == "/file";
                                },
                                folder_.path() / "bodies", 4'000'000}}};
  std::thread thread_;
};

TEST_F(StreamedBody, LiesOnTheDiskWholeAndOnlyUntilTheAnswer) {
  const std::string body(3'000'000, 'x');
  const auto answer = exchange("POST /file HTTP/1.1", sized(body));
  EXPECT_TRUE(answer.ends_with("3000000 as sent")) << answer;
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path() / "bodies"));
}

TEST_F(StreamedBody, MayComeInChunksAndMayBeEmpty) {
  const auto chunked = exchange("POST /file HTTP/1.1",
                                "Transfer-Encoding: chunked\r\n\r\n5\r\nHello\r\n6\r\n, sea!\r\n0\r\n\r\n");
  EXPECT_TRUE(chunked.ends_with("11 as sent")) << chunked;
  const auto empty = exchange("POST /file HTTP/1.1", sized(""));
  EXPECT_TRUE(empty.ends_with("0 as sent")) << empty;
}

TEST_F(StreamedBody, IsRefusedWhenItIsOrGrowsTooLarge) {
  EXPECT_TRUE(
      exchange("POST /file HTTP/1.1", sized(std::string(4'100'000, 'x'))).starts_with("HTTP/1.1 413"));
  std::string chunks;
  for (int i = 0; i < 5; ++i) chunks += "f4240\r\n" + std::string(0xf4240, 'x') + "\r\n";
  const auto grown =
      exchange("POST /file HTTP/1.1", "Transfer-Encoding: chunked\r\n\r\n" + chunks + "0\r\n\r\n");
  EXPECT_TRUE(grown.starts_with("HTTP/1.1 413")) << grown;
  EXPECT_TRUE(!std::filesystem::exists(folder_.path() / "bodies") ||
              std::filesystem::is_empty(folder_.path() / "bodies"));
}

TEST_F(StreamedBody, LeavesOtherBodiesInMemoryUnderTheirOwnLimit) {
  EXPECT_TRUE(exchange("POST /other HTTP/1.1", sized("Hello")).ends_with("in memory: 5"));
  EXPECT_TRUE(exchange("GET /file HTTP/1.1", "\r\n").ends_with("in memory: 0"));
  EXPECT_TRUE(
      exchange("POST /other HTTP/1.1", sized(std::string(2'000'000, 'x'))).starts_with("HTTP/1.1 413"));
}

}  // namespace
}  // namespace floeplan::http::streamed_body_test

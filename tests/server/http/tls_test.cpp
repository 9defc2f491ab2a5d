#include <gtest/gtest.h>
#include <openssl/ssl.h>

#include <boost/asio/ssl/stream.hpp>
#include <cstdlib>

#include "tests/server/http/running_server.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::http::tls_test {
namespace {

namespace net = boost::asio;
using support::echo;
using support::get;

/// A certificate for localhost that the program openssl has signed by its own key.
class Tls : public testing::Test {
 protected:
  void SetUp() override {
    if (!make_certificate(files_)) GTEST_SKIP() << "install the package openssl to run this test";
  }

  bool make_certificate(const TlsFiles& files) const {
    const std::string command =
        "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 2 -subj "
        "/CN=localhost -addext subjectAltName=DNS:localhost -keyout " +
        files.key.string() + " -out " + files.certificate.string() + " 2> /dev/null";
    return std::system(command.c_str()) == 0;
  }

  /// What the server answers over TLS of the given versions; empty when they do not agree.
  std::string exchange(const support::RunningServer& server, int lowest, int highest,
                       const std::string& bytes) const {
    net::ssl::context context{net::ssl::context::tls_client};
    SSL_CTX_set_security_level(context.native_handle(), 0);  // old versions may at least be tried
    SSL_CTX_set_min_proto_version(context.native_handle(), lowest);
    SSL_CTX_set_max_proto_version(context.native_handle(), highest);
    context.load_verify_file(files_.certificate.string());
    context.set_verify_mode(net::ssl::verify_peer);
    net::io_context io;
    net::ssl::stream<net::ip::tcp::socket> stream{io, context};
    stream.next_layer().connect(server.endpoint());
    boost::system::error_code error;
    stream.handshake(net::ssl::stream_base::client, error);
    if (error) return "";
    net::write(stream, net::buffer(bytes), error);
    std::string answer;
    net::read(stream, net::dynamic_buffer(answer), error);
    EXPECT_EQ(error, net::error::eof) << "the end is said, so nobody can cut an answer short";
    return answer;
  }

  support::TemporaryFolder folder_;
  TlsFiles files_{folder_.path() / "cert.pem", folder_.path() / "key.pem"};
};

TEST_F(Tls, CarriesRequestsAndLargeAnswers) {
  const support::RunningServer server{echo, {}, {.tls = files_}};
  const std::string body(900'000, 'x');
  const std::string answer =
      exchange(server, TLS1_2_VERSION, TLS1_3_VERSION,
               "POST /a HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nContent-Length: " +
                   std::to_string(body.size()) + "\r\n\r\n" + body);
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n")) << answer.substr(0, 200);
  EXPECT_TRUE(answer.ends_with("POST /a " + body));
}

TEST_F(Tls, IsVersion1Point2OrLater) {
  const support::RunningServer server{echo, {}, {.tls = files_}};
  EXPECT_NE(exchange(server, TLS1_2_VERSION, TLS1_2_VERSION, get("/")), "");
  EXPECT_NE(exchange(server, TLS1_3_VERSION, TLS1_3_VERSION, get("/")), "");
  EXPECT_EQ(exchange(server, TLS1_VERSION, TLS1_1_VERSION, get("/")), "");
}

TEST_F(Tls, AnswersNothingInTheClear) {
  const support::RunningServer server{echo, {}, {.tls = files_}};
  EXPECT_EQ(server.exchange(get("/")).find("HTTP/1.1"), std::string::npos);
}

TEST_F(Tls, RefusesFilesThatDoNotBelongTogetherOrAreNotThere) {
  const TlsFiles others{folder_.path() / "other-cert.pem", folder_.path() / "other-key.pem"};
  ASSERT_TRUE(make_certificate(others));
  const auto serve_with = [](const TlsFiles& files) {
    Server{{"127.0.0.1", 0}, echo, 1, {}, {.tls = files}};
  };
  EXPECT_THROW(serve_with({files_.certificate, others.key}), std::runtime_error);
  EXPECT_THROW(serve_with({folder_.path() / "none", files_.key}), std::runtime_error);
  EXPECT_THROW(serve_with({files_.certificate, files_.certificate}), std::runtime_error);
}

}  // namespace
}  // namespace floeplan::http::tls_test

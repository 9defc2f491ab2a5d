#include <gtest/gtest.h>
#include <openssl/ssl.h>

#include <boost/asio/read_until.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <cstdlib>
#include <fstream>

#include "tests/server/http/running_server.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::http::tls_test {
namespace {

namespace net = boost::asio;
using support::echo;
using support::get;

/// A self-signed certificate for localhost, made with the program openssl.
class Tls : public testing::Test {
 protected:
  void SetUp() override {
    if (!make_certificate(files_)) GTEST_SKIP() << "install the package openssl to run this test";
  }

  bool make_certificate(const TlsFiles& files,
                        const std::string& kind = "ec -pkeyopt ec_paramgen_curve:P-256") const {
    const std::string command = "openssl req -x509 -newkey " + kind +
                                " -nodes -days 2 -subj "
                                "/CN=localhost -addext subjectAltName=DNS:localhost -keyout " +
                                files.key.string() + " -out " + files.certificate.string() + " 2> /dev/null";
    return std::system(command.c_str()) == 0;
  }

  /// The server's answer over TLS with the given versions; empty if they cannot agree on one.
  std::string exchange(const support::RunningServer& server, int lowest, int highest,
                       const std::string& bytes, const char* ciphers = nullptr) const {
    net::ssl::context context{net::ssl::context::tls_client};
    SSL_CTX_set_security_level(context.native_handle(), 0);  // so that old versions are at least tried
    SSL_CTX_set_min_proto_version(context.native_handle(), lowest);
    SSL_CTX_set_max_proto_version(context.native_handle(), highest);
    if (ciphers != nullptr) SSL_CTX_set_cipher_list(context.native_handle(), ciphers);
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

/// With both kinds of keys, because each has its own ciphers.
TEST_F(Tls, SpeaksVersion1Point2WithForwardSecrecyAndAuthenticatedEncryptionAlone) {
  for (const char* kind : {"ec -pkeyopt ec_paramgen_curve:P-256", "rsa:2048"}) {
    ASSERT_TRUE(make_certificate(files_, kind));
    const support::RunningServer server{echo, {}, {.tls = files_}};
    const auto by = [&](const char* ciphers) {
      return exchange(server, TLS1_2_VERSION, TLS1_2_VERSION, get("/"), ciphers) != "";
    };
    for (const char* good : {"ECDHE+AESGCM", "ECDHE+CHACHA20"}) EXPECT_TRUE(by(good)) << kind << good;
    for (const char* bad :
         {"ECDHE+AES:!AESGCM:!AESCCM", "kRSA", "DHE", "AES128-GCM-SHA256", "ECDHE-RSA-AES256-SHA384",
          "ECDHE-ECDSA-AES128-SHA", "ECDHE+AESCCM", "NULL", "PSK"})
      EXPECT_FALSE(by(bad)) << kind << bad;
  }
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

/// A TLS client that keeps its connection open.
class TlsClient {
 public:
  explicit TlsClient(const support::RunningServer& server) {
    stream_.next_layer().connect(server.endpoint());
    stream_.handshake(net::ssl::stream_base::client);
  }
  [[nodiscard]] std::string serial() {
    const std::unique_ptr<X509, void (*)(X509*)> shown{SSL_get1_peer_certificate(stream_.native_handle()),
                                                       X509_free};
    const ASN1_INTEGER* number = X509_get0_serialNumber(shown.get());
    return {reinterpret_cast<const char*>(number->data), static_cast<std::size_t>(number->length)};
  }
  void send(const std::string& bytes) { net::write(stream_, net::buffer(bytes)); }
  std::string read_until(const std::string& end) {
    const std::size_t length = net::read_until(stream_, net::dynamic_buffer(held_), end);
    const std::string text = held_.substr(0, length);
    held_.erase(0, length);
    return text;
  }

 private:
  net::io_context io_;
  net::ssl::context context_{net::ssl::context::tls_client};
  net::ssl::stream<net::ip::tcp::socket> stream_{io_, context_};
  std::string held_;
};

/// Ends its stream when it is told to.
routes::Response answer_or_stream(const routes::Request& request) {
  routes::Response response = echo(request);
  if (request.path == "/stream") {
    response.streams = true;
    response.body = "piece\n";
    response.wait = routes::Wait{core::Seconds{0.05}, "more", [](const auto&) { return nullptr; }};
  }
  return response;
}

TEST_F(Tls, ShowsNewConnectionsTheNewCertificateAndLeavesTheOthersAlone) {
  support::RunningServer server{answer_or_stream, {}, {.tls = files_}};
  const std::string request = "GET /a HTTP/1.1\r\nHost: localhost\r\n\r\n";
  TlsClient early{server};
  TlsClient listener{server};
  early.send(request);
  EXPECT_NE(early.read_until("GET /a "), "");
  listener.send("GET /stream HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_NE(listener.read_until("piece"), "");
  const auto goes_on = [&] {
    early.send(request);
    EXPECT_NE(early.read_until("GET /a "), "");
    EXPECT_NE(listener.read_until("piece"), "");
  };

  ASSERT_TRUE(make_certificate(files_));
  server.reload();
  const std::string renewed = TlsClient{server}.serial();
  EXPECT_NE(renewed, early.serial());
  goes_on();

  std::ofstream{files_.certificate} << "no certificate\n";
  server.reload();
  EXPECT_EQ(TlsClient{server}.serial(), renewed) << "what was good stays in force";
  goes_on();
}

TEST_F(Tls, HasBrowsersComeByHttpsAloneWhenItIsToldTo) {
  const auto answer_of = [&](bool https_only, const std::string& target) {
    const support::RunningServer server{answer_or_stream, {}, {.tls = files_, .https_only = https_only}};
    TlsClient client{server};
    client.send("GET " + target + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
    return client.read_until("\r\n\r\n");
  };
  for (const char* target : {"/a", "/stream", "/%zz"}) {
    EXPECT_NE(answer_of(true, target).find("\r\nStrict-Transport-Security: max-age="), std::string::npos)
        << target;
    EXPECT_EQ(answer_of(false, target).find("Strict-Transport-Security"), std::string::npos) << target;
  }
}

}  // namespace
}  // namespace floeplan::http::tls_test

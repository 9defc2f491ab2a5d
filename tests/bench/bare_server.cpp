// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>

// Reference for the rate of the server: the same libraries, but it returns the bytes of a file for every
// request.

namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;

class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(net::ip::tcp::socket socket, const std::string& body) : stream_{std::move(socket)}, body_{body} {
    stream_.socket().set_option(net::ip::tcp::no_delay{true});
  }

  void read() {
    request_ = {};
    http::async_read(stream_, buffer_, request_, [self = shared_from_this()](beast::error_code error, auto) {
      if (!error) self->write();
    });
  }

 private:
  void write() {
    response_ = {};
    response_.result(http::status::ok);
    response_.set(http::field::content_type, "application/json");
    response_.keep_alive(request_.keep_alive());
    response_.body() = {body_.data(), body_.size()};
    response_.prepare_payload();
    http::async_write(stream_, response_, [self = shared_from_this()](beast::error_code error, auto) {
      if (!error) self->read();
    });
  }

  beast::tcp_stream stream_;
  const std::string& body_;  // borrowed
  beast::flat_buffer buffer_;
  http::request<http::string_body> request_;
  http::response<http::span_body<const char>> response_;
};

void accept(net::ip::tcp::acceptor& acceptor, const std::string& body) {
  acceptor.async_accept([&](beast::error_code error, net::ip::tcp::socket socket) {
    if (!error) std::make_shared<Session>(std::move(socket), body)->read();
    accept(acceptor, body);
  });
}

}  // namespace

/// usage: floeplan_bare_server FILE
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: floeplan_bare_server FILE\n";
    return 2;
  }
  std::ifstream file{argv[1], std::ios::binary};
  const std::string body{std::istreambuf_iterator<char>{file}, {}};
  net::io_context io{1};
  net::ip::tcp::acceptor acceptor{io, {net::ip::address_v4::loopback(), 0}};
  accept(acceptor, body);
  std::cerr << "serving http://127.0.0.1:" << acceptor.local_endpoint().port() << std::endl;
  io.run();
}

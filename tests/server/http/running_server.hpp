#pragma once

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <string>
#include <thread>

#include "server/http/server.hpp"

namespace floeplan::support {

/// A server with its own thread on a free port of the loopback address.
class RunningServer {
 public:
  explicit RunningServer(routes::Handler handler, http::Limits limits = {}, http::Equipment equipment = {})
      : server_{{"127.0.0.1", 0}, std::move(handler), 2, limits, std::move(equipment)},
        thread_{[this] { server_.run(); }} {}
  RunningServer(const RunningServer&) = delete;
  RunningServer& operator=(const RunningServer&) = delete;
  ~RunningServer() {
    server_.stop();
    thread_.join();
  }

  [[nodiscard]] boost::asio::ip::tcp::endpoint endpoint() const {
    return {boost::asio::ip::make_address("127.0.0.1"), server_.port()};
  }

  /// Returns when new connections get the new settings.
  void reload() {
    server_.reload();
    (void)exchange("GET / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n");  // is handled after the reload
  }

  /// Sends the bytes and reads until the server closes the connection.
  [[nodiscard]] std::string exchange(const std::string& bytes) const {
    boost::asio::io_context io;
    boost::asio::ip::tcp::socket socket{io};
    socket.connect(endpoint());
    return exchange(socket, bytes);
  }
  static std::string exchange(boost::asio::ip::tcp::socket& socket, const std::string& bytes) {
    boost::system::error_code error;
    boost::asio::write(socket, boost::asio::buffer(bytes),
                       error);  // the server may refuse before it has read everything
    std::string answer;
    boost::asio::read(socket, boost::asio::dynamic_buffer(answer), error);
    return answer;
  }

 private:
  http::Server server_;
  std::thread thread_;
};

inline routes::Response echo(const routes::Request& request) {
  routes::Response response;
  response.content_type = "text/plain";
  response.body = request.method + " " + request.path + " " + request.body;
  return response;
}

inline std::string get(const std::string& target, const std::string& headers = "") {
  return "GET " + target + " HTTP/1.1\r\nHost: x\r\nConnection: close\r\n" + headers + "\r\n";
}

}  // namespace floeplan::support

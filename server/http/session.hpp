#pragma once

// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

#include "api/routes/message.hpp"
#include "server/http/server.hpp"

namespace floeplan::http {

/// What all sessions of a server share.
struct SessionShare {
  routes::Handler handler;
  Limits limits;
  boost::asio::thread_pool pool;

  SessionShare(routes::Handler answer, Limits bounds, std::size_t threads)
      : handler{std::move(answer)}, limits{bounds}, pool{threads} {}
};

/// One connection: reads requests, has them answered, writes the answers, until the client or the server ends
/// it.
/// Threads  everything on the I/O thread, but for the handler
class Session {
 public:
  Session(boost::asio::ip::tcp::socket socket, SessionShare& share);

  boost::asio::awaitable<void> run();
  /// Ends the connection after the request that is being answered; at once when there is none.
  void finish();

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;

  boost::asio::awaitable<bool> exchange();
  boost::asio::awaitable<boost::beast::error_code> read(Parser& parser);
  boost::asio::awaitable<routes::Response> answer(routes::Request request);
  boost::asio::awaitable<routes::Response> answer_on_pool(const routes::Request& request);
  boost::asio::awaitable<routes::Response> wait_and_answer(routes::Request& request, routes::Wait wait);
  boost::asio::awaitable<bool> write(const routes::Response& response, bool head_only, bool keep_alive);
  boost::asio::awaitable<void> refuse(boost::beast::error_code fault);
  boost::asio::awaitable<void> linger();

  boost::beast::tcp_stream stream_;
  boost::beast::flat_buffer buffer_;
  SessionShare& share_;  // borrowed
  std::string peer_;
  bool idle_{true};
  bool finishing_{false};
};

}  // namespace floeplan::http

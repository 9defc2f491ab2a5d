#pragma once

// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <optional>
#include <string_view>

#include "api/routes/message.hpp"
#include "server/http/server.hpp"

namespace floeplan::http {

/// What all sessions of a server share.
struct SessionShare {
  routes::Handler handler;
  Limits limits;
  Streaming streaming;
  boost::asio::thread_pool pool;
  std::size_t streams{0};  // that are open; on the I/O thread alone

  SessionShare(routes::Handler answer, Limits bounds, Streaming to_disk, std::size_t threads)
      : handler{std::move(answer)}, limits{bounds}, streaming{std::move(to_disk)}, pool{threads} {}
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
  using Head = boost::beast::http::request_parser<boost::beast::http::empty_body>;

  boost::asio::awaitable<bool> exchange();
  boost::asio::awaitable<boost::beast::error_code> read_head(Head& head);
  boost::asio::awaitable<boost::beast::error_code> receive(Head& head, bool to_disk, routes::Request& body,
                                                           std::optional<BodySink>& sink);
  boost::asio::awaitable<boost::beast::error_code> read_body(Head& head, routes::Request& request);
  boost::asio::awaitable<boost::beast::error_code> stream_body(Head& head, BodySink& sink);
  boost::asio::awaitable<boost::beast::error_code> store(BodySink& sink, std::string_view bytes);
  boost::asio::awaitable<routes::Response> answer(routes::Request& request);
  boost::asio::awaitable<routes::Response> answer_on_pool(const routes::Request& request);
  boost::asio::awaitable<routes::Response> wait_and_answer(routes::Request& request, routes::Wait wait);
  boost::asio::awaitable<std::size_t> stream(routes::Request& request, routes::Response piece);
  boost::asio::awaitable<bool> write_chunk(std::string_view piece);
  boost::asio::awaitable<bool> write(const routes::Response& response, bool head_only, bool keep_alive);
  boost::asio::awaitable<void> refuse(boost::beast::error_code fault, std::uint64_t most_bytes);
  [[nodiscard]] bool goes_to_disk(const Head& head) const;
  boost::asio::awaitable<void> linger();

  boost::beast::tcp_stream stream_;
  boost::beast::flat_buffer buffer_;
  SessionShare& share_;  // borrowed
  std::string peer_;
  bool idle_{true};
  bool finishing_{false};
};

}  // namespace floeplan::http

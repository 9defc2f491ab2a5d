#pragma once

// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <atomic>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <optional>
#include <string_view>

#include "api/routes/request/message.hpp"
#include "server/http/client_counts.hpp"
#include "server/http/fair_line.hpp"
#include "server/http/memory_budget.hpp"
#include "server/http/server_settings.hpp"
#include "server/http/transport.hpp"
#include "server/http/waiting_line.hpp"

namespace floeplan::http {

/// The value of the header Strict-Transport-Security (RFC 6797).
constexpr const char* https_only_for_a_year = "max-age=31536000";

/// State shared by all sessions of a server.
struct SessionShare {
  routes::Handler handler;
  Limits limits;
  Equipment equipment;
  std::shared_ptr<boost::asio::ssl::context> tls;  // for new connections; empty: no TLS
  MemoryBudget memory;
  boost::asio::thread_pool pool;
  FairLine line;         // for the pool; I/O thread only
  ClientCounts streams;  // open event streams; I/O thread only
  ClientCounts files;    // uploads that are being received; I/O thread only
  WaitingLine waiting;   // I/O thread only

  SessionShare(routes::Handler answer, Limits bounds, Equipment tools, std::size_t threads);

  [[nodiscard]] std::string client_of(const routes::Request& request) const;
};

/// One connection: reads requests, lets the handler answer them and writes the answers, until the client or
/// the server closes it.
/// Threads  I/O thread only, except for the handler
class Session {
 public:
  Session(boost::asio::ip::tcp::socket socket, SessionShare& share);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  boost::asio::awaitable<void> run();
  /// Closes the connection after the running request, or immediately if there is none.
  void finish();
  /// Closes the connection immediately.
  void drop();
  [[nodiscard]] const std::string& peer() const { return peer_; }

 private:
  using Head = boost::beast::http::request_parser<boost::beast::http::empty_body>;

  boost::asio::awaitable<bool> exchange();
  boost::asio::awaitable<boost::beast::error_code> read_head(Head& head);
  boost::asio::awaitable<boost::beast::error_code> read_strict_head();
  boost::asio::awaitable<boost::beast::error_code> receive(Head& head, bool to_disk, routes::Request& body,
                                                           std::optional<BodySink>& sink);
  boost::asio::awaitable<boost::beast::error_code> read_body(Head& head, routes::Request& request);
  boost::asio::awaitable<boost::beast::error_code> stream_body(Head& head, BodySink& sink);
  boost::asio::awaitable<boost::beast::error_code> store(BodySink& sink, std::string_view bytes);
  boost::asio::awaitable<void> invite_body(const Head& head);
  boost::asio::awaitable<std::optional<routes::Response>> ask_doors(routes::Request& request);
  boost::asio::awaitable<routes::Response> answer(routes::Request& request);
  template <class Result>
  boost::asio::awaitable<Result> in_turn(const routes::Request& request,
                                         std::function<Result()> work);  // runs on the pool
  boost::asio::awaitable<routes::Response> answer_in_turn(const routes::Request& request);
  [[nodiscard]] routes::Response ask_handler(const routes::Request& request);
  [[nodiscard]] std::optional<routes::Response> ask_at_once(const routes::Request& request);
  boost::asio::awaitable<routes::Response> wait_and_answer(routes::Request& request, routes::Wait wait);
  boost::asio::awaitable<std::size_t> stream(routes::Request& request, routes::Response piece);
  boost::asio::awaitable<bool> write_chunk(std::string_view piece);
  boost::asio::awaitable<bool> write(const routes::Response& response, bool head_only, bool keep_alive);
  boost::asio::awaitable<void> refuse(boost::beast::error_code fault, bool in_first_line,
                                      std::uint64_t most_bytes);
  [[nodiscard]] bool goes_to_disk(const Head& head) const;
  boost::asio::awaitable<void> linger();
  /// Call before waiting for the client to send or receive bytes.
  void wait_for_client();
  /// Call before the server works on a request.
  void stop_waiting();

  Transport stream_;
  static constexpr std::size_t most_buffered =
      256UL * 1024;  // limits a line, which stays in memory until its end
  boost::beast::flat_buffer buffer_{most_buffered};
  SessionShare& share_;  // borrowed
  std::string peer_;
  std::optional<WaitingLine::Ticket> waiting_;  // the session's place among those waiting for their clients
  bool fresh_{true};                            // nothing was received yet
  bool idle_{true};
  bool finishing_{false};
};

}  // namespace floeplan::http

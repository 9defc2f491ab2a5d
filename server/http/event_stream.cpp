// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>

#include "server/http/session.hpp"

namespace floeplan::http {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
using beast::error_code;
using routes::Request;
using routes::Response;

/// Wakes a coroutine that waits for it; a call before the wait is not lost.
/// Threads  only on the executor, which has one thread
class WakeUp {
 public:
  explicit WakeUp(const net::any_io_executor& executor) : timer_{executor} {}

  void wake() {
    woken_ = true;
    timer_.cancel();
  }
  net::awaitable<void> wait_until(std::chrono::steady_clock::time_point moment) {
    error_code ignored;
    timer_.expires_at(moment);
    if (!woken_) co_await timer_.async_wait(net::redirect_error(net::use_awaitable, ignored));
  }
  /// Whether the stream was woken since the last call.
  bool take() { return std::exchange(woken_, false); }

 private:
  net::steady_timer timer_;
  bool woken_{false};
};

}  // namespace

/// Sends the pieces of a stream. The next piece is requested after the last one was sent, so a slow client
/// delays nobody and nothing is stored for it. Returns the bytes of all pieces.
net::awaitable<std::size_t> Session::stream(Request& request, Response piece) {
  using std::chrono::steady_clock;
  const ClientCounts::One counted{share_.streams, share_.client_of(request)};
  beast::http::response<beast::http::empty_body> head{static_cast<beast::http::status>(piece.status), 11};
  head.set(beast::http::field::content_type, piece.content_type);
  for (const auto& [name, value] : piece.headers) head.insert(name, value);
  if (share_.equipment.https_only) head.insert("Strict-Transport-Security", https_only_for_a_year);
  head.chunked(true);
  head.keep_alive(false);
  beast::http::response_serializer<beast::http::empty_body> serializer{head};
  error_code error;
  stream_.expires_after(share_.limits.write_time);
  co_await beast::http::async_write_header(stream_, serializer,
                                           net::redirect_error(net::use_awaitable, error));
  std::size_t sent = 0;
  if (error) co_return sent;

  const auto executor = co_await net::this_coro::executor;
  const auto wake_up = std::make_shared<WakeUp>(executor);
  std::shared_ptr<void> subscription;
  if (piece.wait) {
    subscription =
        piece.wait->subscribe([executor, wake_up] { net::post(executor, [wake_up] { wake_up->wake(); }); });
  }
  while (co_await write_chunk(piece.body)) {
    sent += piece.body.size();
    if (!piece.wait || finishing_) {
      co_await net::async_write(stream_, beast::http::make_chunk_last(),
                                net::redirect_error(net::use_awaitable, error));
      break;
    }
    // The second piece is requested without a wait, because changes before the subscription woke nobody.
    const auto heartbeat =
        steady_clock::now() + std::chrono::duration_cast<std::chrono::milliseconds>(piece.wait->at_most);
    bool due = false;
    constexpr std::chrono::seconds look_again{1};  // also detects that the server stops
    while (!finishing_ && request.resumption && !wake_up->take() && !due) {
      co_await wake_up->wait_until(std::min(heartbeat, steady_clock::now() + look_again));
      due = steady_clock::now() >= heartbeat;
    }
    request.resumption = routes::Resumption{piece.wait->token, due};
    piece = co_await answer_in_turn(request);
    if (!piece.streams) break;  // the store cannot be read; the client will reconnect
  }
  co_return sent;
}

net::awaitable<bool> Session::write_chunk(std::string_view piece) {
  error_code error;
  stream_.expires_after(share_.limits.write_time);
  if (!piece.empty()) {
    co_await net::async_write(stream_, beast::http::make_chunk(net::buffer(piece.data(), piece.size())),
                              net::redirect_error(net::use_awaitable, error));
  }
  co_return !error;
}

}  // namespace floeplan::http

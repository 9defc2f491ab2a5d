#pragma once

// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <boost/asio/async_result.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <memory>
#include <optional>

namespace floeplan::http {

/// One connection's way for bytes, in the clear or by TLS: an AsyncReadStream and AsyncWriteStream as Beast wants them,
/// with a time limit over whatever is under way.
/// Threads  the I/O thread alone
class Transport {
 public:
  using executor_type = boost::beast::tcp_stream::executor_type;

  /// By TLS when there is a context, which is borrowed.
  Transport(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context* tls) : plain_{std::move(socket)} {
    if (tls != nullptr) tls_.emplace(plain_, *tls);
  }

  executor_type get_executor() { return plain_.get_executor(); }
  boost::asio::ip::tcp::socket& socket() { return plain_.socket(); }
  void expires_after(std::chrono::steady_clock::duration time) { plain_.expires_after(time); }
  void cancel() { plain_.cancel(); }

  /// What TLS has to settle before the first byte; nothing in the clear.
  boost::asio::awaitable<boost::beast::error_code> open();
  /// Says that nothing more will be sent.
  boost::asio::awaitable<void> end();
  /// The same for a connection that is given up, where TLS has no time for a goodbye.
  void stop_sending();

  template <class Buffers, class Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    return boost::asio::async_initiate<Token, void(boost::beast::error_code, std::size_t)>(
        [this](auto handler, const Buffers& into) {
          if (tls_) {
            tls_->async_read_some(into, std::move(handler));
          } else {
            plain_.async_read_some(into, std::move(handler));
          }
        },
        token, buffers);
  }

  template <class Buffers, class Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    return boost::asio::async_initiate<Token, void(boost::beast::error_code, std::size_t)>(
        [this](auto handler, const Buffers& from) {
          if (tls_) {
            tls_->async_write_some(from, std::move(handler));
          } else {
            plain_.async_write_some(from, std::move(handler));
          }
        },
        token, buffers);
  }

 private:
  boost::beast::tcp_stream plain_;
  std::optional<boost::asio::ssl::stream<boost::beast::tcp_stream&>> tls_;
};

}  // namespace floeplan::http

#pragma once

// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <boost/asio/async_result.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/container/static_vector.hpp>
#include <memory>
#include <optional>

#include "server/http/completion.hpp"

namespace floeplan::http {

/// The byte stream of one connection, plain or TLS: an AsyncReadStream and AsyncWriteStream for Beast, with a
/// time limit for the running operation.
/// Threads  the I/O thread alone
class Transport {
 public:
  using executor_type = boost::beast::tcp_stream::executor_type;

  /// Uses TLS if there is a context. It keeps the context alive, because new connections may get another one.
  Transport(boost::asio::ip::tcp::socket socket, std::shared_ptr<boost::asio::ssl::context> tls)
      : context_{std::move(tls)}, plain_{std::move(socket)} {
    if (context_) tls_.emplace(plain_, *context_);
  }

  executor_type get_executor() { return plain_.get_executor(); }
  boost::asio::ip::tcp::socket& socket() { return plain_.socket(); }
  void expires_after(std::chrono::steady_clock::duration time) { plain_.expires_after(time); }
  void cancel() { plain_.cancel(); }

  /// Does the TLS handshake; nothing without TLS.
  boost::asio::awaitable<boost::beast::error_code> open();
  /// Tells the client that nothing more will be sent.
  boost::asio::awaitable<void> end();
  /// Ends a connection that is given up, without waiting for TLS to close properly.
  void stop_sending();

  template <class Buffers, class Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    return boost::asio::async_initiate<Token, void(boost::beast::error_code, std::size_t)>(
        [this](auto handler, const Buffers& into) {
          read_some(first_of<boost::asio::mutable_buffer>(into), {std::move(handler), get_executor()});
        },
        token, buffers);
  }

  template <class Buffers, class Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    return boost::asio::async_initiate<Token, void(boost::beast::error_code, std::size_t)>(
        [this](auto handler, const Buffers& from) {
          write_some(first_of<boost::asio::const_buffer>(from), {std::move(handler), get_executor()});
        },
        token, buffers);
  }

 private:
  /// At most as many buffers as one system call accepts. The caller gets the number of transferred bytes and
  /// calls again for the rest.
  template <class Buffer>
  using Buffers = boost::container::static_vector<Buffer, 64>;

  template <class Buffer, class Sequence>
  static Buffers<Buffer> first_of(const Sequence& sequence) {
    Buffers<Buffer> result;
    const auto end = boost::asio::buffer_sequence_end(sequence);
    for (auto it = boost::asio::buffer_sequence_begin(sequence); it != end; ++it) {
      if (result.size() == result.capacity()) break;
      if (const Buffer buffer{*it}; buffer.size() > 0) result.push_back(buffer);
    }
    return result;
  }

  void read_some(const Buffers<boost::asio::mutable_buffer>& into, Completion completion);
  void write_some(const Buffers<boost::asio::const_buffer>& from, Completion completion);

  std::shared_ptr<boost::asio::ssl::context> context_;  // empty: no TLS
  boost::beast::tcp_stream plain_;
  std::optional<boost::asio::ssl::stream<boost::beast::tcp_stream&>> tls_;
};

}  // namespace floeplan::http

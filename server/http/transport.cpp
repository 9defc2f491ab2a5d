#include "server/http/transport.hpp"

#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>

namespace floeplan::http {

namespace net = boost::asio;
using boost::beast::error_code;

net::awaitable<error_code> Transport::open() {
  error_code error;
  if (tls_) {
    co_await tls_->async_handshake(net::ssl::stream_base::server,
                                   net::redirect_error(net::use_awaitable, error));
  }
  co_return error;
}

net::awaitable<void> Transport::end() {
  error_code ignored;
  if (tls_) {
    constexpr std::chrono::seconds time_for_goodbye{2};
    expires_after(time_for_goodbye);
    co_await tls_->async_shutdown(net::redirect_error(net::use_awaitable, ignored));
  }
  stop_sending();
}

void Transport::read_some(const Buffers<net::mutable_buffer>& into, Completion completion) {
  if (tls_) {
    tls_->async_read_some(into, std::move(completion));
  } else {
    plain_.async_read_some(into, std::move(completion));
  }
}

void Transport::write_some(const Buffers<net::const_buffer>& from, Completion completion) {
  if (tls_) {
    tls_->async_write_some(from, std::move(completion));
  } else {
    plain_.async_write_some(from, std::move(completion));
  }
}

void Transport::stop_sending() {
  error_code ignored;
  socket().shutdown(net::ip::tcp::socket::shutdown_send, ignored);
}

}  // namespace floeplan::http

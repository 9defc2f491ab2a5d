// clang-format off: Asio's awaitable uses std::exchange, but does not include it
#include <utility>
// clang-format on

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <vector>

#include "api/log/log.hpp"
#include "server/http/refusals.hpp"
#include "server/http/request_head.hpp"
#include "server/http/session.hpp"
#include "server/http/strict_head.hpp"

namespace floeplan::http {

namespace net = boost::asio;
namespace beast = boost::beast;
using beast::error_code;
using routes::Request;

namespace {

/// Refuses chunk extensions: nothing uses them, and servers parse them differently (RFC 9112, 7.1.1).
void refuse_chunk_extension(std::uint64_t, beast::string_view extension, error_code& error) {
  if (!extension.empty()) error = beast::http::error::bad_chunk_extension;
}

}  // namespace

bool Session::goes_to_disk(const Head& head) const {
  if (!share_.equipment.streaming.wanted) return false;
  const auto target = head.get().target();
  const auto parsed = routes::parse_target({target.data(), target.size()});
  return parsed && share_.equipment.streaming.wanted(std::string{head.get().method_string()}, parsed->path);
}

net::awaitable<error_code> Session::read_head(Head& head) {
  error_code error;
  if (buffer_.size() == 0) {
    idle_ = true;
    constexpr std::size_t first_read = 4096;
    stream_.expires_after(fresh_ ? share_.limits.first_byte_time : share_.limits.idle_time);
    const std::size_t n = co_await stream_.async_read_some(buffer_.prepare(first_read),
                                                           net::redirect_error(net::use_awaitable, error));
    buffer_.commit(n);
    if (error) co_return error == net::error::eof ? error_code{beast::http::error::end_of_stream} : error;
  }
  idle_ = false;
  fresh_ = false;
  stream_.expires_after(share_.limits.header_time);
  error = co_await read_strict_head();
  if (error) co_return error;
  co_await beast::http::async_read_header(stream_, buffer_, head,
                                          net::redirect_error(net::use_awaitable, error));
  if (!error && !names_one_host(head.get())) error = beast::http::error::bad_field;
  if (error || head.is_done()) co_return error;

  const auto length = head.content_length();
  const std::uint64_t most =
      goes_to_disk(head) ? share_.equipment.streaming.most_bytes : share_.limits.body_bytes;
  if (length && *length > most) co_return beast::http::error::body_limit;
  co_return error;
}

/// Reads until the header is complete and valid, or too long.
net::awaitable<error_code> Session::read_strict_head() {
  StrictHead head;
  while (buffer_.size() <= share_.limits.header_bytes) {
    const auto bytes = buffer_.data();
    const auto state = head.look_at({static_cast<const char*>(bytes.data()), bytes.size()});
    if (state == StrictHead::State::faulty) co_return beast::http::error::bad_field;
    if (state == StrictHead::State::complete) break;
    error_code error;
    constexpr std::size_t next_read = 4096;
    const std::size_t n = co_await stream_.async_read_some(buffer_.prepare(next_read),
                                                           net::redirect_error(net::use_awaitable, error));
    buffer_.commit(n);
    if (error) co_return error == net::error::eof ? error_code{beast::http::error::partial_message} : error;
  }
  co_return error_code{};
}

/// Sends "100 Continue" if the client waits for it before it sends a large body.
net::awaitable<void> Session::invite_body(const Head& head) {
  const bool asked = beast::iequals(head.get()[beast::http::field::expect], "100-continue");
  if (!asked || head.is_done()) co_return;
  error_code broken;  // an error is found again when the body is read
  beast::http::response<beast::http::empty_body> go_on{beast::http::status::continue_, 11};
  stream_.expires_after(share_.limits.write_time);
  co_await beast::http::async_write(stream_, go_on, net::redirect_error(net::use_awaitable, broken));
}

net::awaitable<error_code> Session::receive(Head& head, bool to_disk, Request& body,
                                            std::optional<BodySink>& sink) {
  co_await invite_body(head);
  if (!to_disk) co_return co_await read_body(head, body);
  try {
    sink.emplace(share_.equipment.streaming.folder);
  } catch (const std::system_error& closed) {
    log::error({"peer=", peer_, " ", closed.what()});
    co_return error_code{closed.code().value(), boost::system::generic_category()};
  }
  co_return co_await stream_body(head, *sink);
}

net::awaitable<error_code> Session::read_body(Head& head, Request& request) {
  error_code error;
  beast::http::request_parser<beast::http::string_body> parser{std::move(head)};
  parser.body_limit(share_.limits.body_bytes);
  parser.on_chunk_header(refuse_chunk_extension);
  const std::uint64_t bytes =
      parser.content_length().value_or(parser.is_done() ? 0 : share_.limits.body_bytes);
  constexpr std::uint64_t always_welcome = 65'536;  // bytes; accepted even if other requests use all memory
  if (bytes > always_welcome && !share_.memory.has(bytes)) co_return no_memory();
  const MemoryBudget::Part part{share_.memory, bytes};
  if (!parser.is_done()) {
    stream_.expires_after(share_.limits.body_time);
    co_await beast::http::async_read(stream_, buffer_, parser,
                                     net::redirect_error(net::use_awaitable, error));
  }
  request.body = std::move(parser.get().body());
  co_return error;
}

/// Writes the body to disk; keeps at most one block of it in memory.
net::awaitable<error_code> Session::stream_body(Head& head, BodySink& sink) {
  constexpr std::size_t block_bytes = 65'536;
  std::vector<char> block(block_bytes);
  beast::http::request_parser<beast::http::buffer_body> parser{std::move(head)};
  parser.body_limit(share_.equipment.streaming.most_bytes);
  parser.on_chunk_header(refuse_chunk_extension);
  while (!parser.is_done()) {
    error_code error;
    parser.get().body().data = block.data();
    parser.get().body().size = block.size();
    stream_.expires_after(share_.limits.body_time);
    co_await beast::http::async_read(stream_, buffer_, parser,
                                     net::redirect_error(net::use_awaitable, error));
    if (error && error != beast::http::error::need_buffer) co_return error;
    error = co_await net::co_spawn(share_.pool.get_executor(),
                                   store(sink, {block.data(), block.size() - parser.get().body().size}),
                                   net::use_awaitable);
    if (error) co_return error;
  }
  co_return error_code{};
}

/// Runs on a handler thread, so that a slow disk does not delay other connections.
net::awaitable<error_code> Session::store(BodySink& sink, std::string_view bytes) {
  try {
    sink.add(bytes);
  } catch (const std::system_error& full) {
    log::error({"peer=", peer_, " ", full.what()});
    co_return error_code{full.code().value(), boost::system::generic_category()};
  }
  co_return error_code{};
}

}  // namespace floeplan::http

#include "server/http/session.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <charconv>
#include <optional>
#include <vector>

#include "server/http/finish_response.hpp"

namespace floeplan::http {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
using beast::error_code;
using routes::Request;
using routes::Response;

core::UtcTime now() { return std::chrono::system_clock::now(); }

std::string next_request_id() {
  static std::atomic<std::uint64_t> last{0};
  return std::to_string(++last);
}

std::string lower_case(std::string_view text) {
  std::string result;
  for (const char c : text) result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

/// All but the body.
std::optional<Request> to_request(const beast::http::request_header<>& message) {
  const auto target = message.target();
  auto parsed = routes::parse_target({target.data(), target.size()});
  if (!parsed) return std::nullopt;
  Request request;
  request.method = std::string{message.method_string()};
  request.path = std::move(parsed->path);
  request.query = std::move(parsed->query);
  for (const auto& field : message) {
    const auto name = field.name_string();
    request.headers[lower_case({name.data(), name.size()})] = std::string{field.value()};
  }
  return request;
}

/// A problem (RFC 9457) that no resource has said; the texts are ours and need no escaping.
Response problem(int status, const std::string& slug, const std::string& title, const std::string& detail) {
  Response response;
  response.status = status;
  response.content_type = "application/problem+json";
  response.body = R"({"type":"/problems/)" + slug + R"(","title":")" + title + R"(","status":)" +
                  std::to_string(status) + R"(,"detail":")" + detail + R"("})";
  return finish_response({}, std::move(response));
}

Response too_many_streams() {
  Response response = problem(503, "too-many-streams", "Too many streams",
                              "Too many event streams are open; ask again later.");
  response.headers.emplace_back("Retry-After", "30");
  return response;
}

}  // namespace

Session::Session(net::ip::tcp::socket socket, SessionShare& share)
    : stream_{std::move(socket)}, share_{share} {
  error_code ignored;
  stream_.socket().set_option(net::ip::tcp::no_delay{true}, ignored);
  const auto endpoint = stream_.socket().remote_endpoint(ignored);
  peer_ = endpoint.address().to_string(ignored);
}

net::awaitable<void> Session::run() {
  while (!finishing_ && co_await exchange()) {
  }
  error_code ignored;
  stream_.socket().shutdown(net::ip::tcp::socket::shutdown_send, ignored);
}

void Session::finish() {
  finishing_ = true;
  if (idle_) stream_.cancel();
}

/// Reads one request and answers it. False: the connection is to end.
net::awaitable<bool> Session::exchange() {
  Head head;
  head.header_limit(share_.limits.header_bytes);
  head.body_limit(std::max(share_.limits.body_bytes, share_.streaming.most_bytes));
  error_code error = co_await read_head(head);
  idle_ = false;
  const bool to_disk = goes_to_disk(head);
  const std::string method{head.get().method_string()};
  const std::string target = std::string{head.get().target()}.substr(0, 300);
  const bool head_only = head.get().method() == beast::http::verb::head;
  const bool keep_alive = !error && head.keep_alive();
  std::optional<Request> request;
  std::optional<BodySink> sink;  // until the answer is there
  Request body;
  if (!error) {
    request = to_request(head.get());
    error = co_await receive(head, to_disk, body, sink);
  }
  if (error) {
    sink.reset();  // while the client reads why
    co_await refuse(error, to_disk ? share_.streaming.most_bytes : share_.limits.body_bytes);
    co_return false;
  }

  const auto begin = std::chrono::steady_clock::now();
  Response response;
  if (request) {
    request->body = std::move(body.body);
    if (sink) request->body_file = sink->finish();
    request->now = now();
    response = co_await answer(*request);
  } else {
    response = problem(400, "invalid-target", "Invalid request", "The address of the request is not valid.");
  }
  const std::string id = next_request_id();
  response.headers.emplace_back("X-Request-Id", id);
  const bool streams = response.streams && !head_only && share_.streams < share_.limits.streams;
  if (response.streams && !streams && !head_only) response = too_many_streams();
  const bool open = keep_alive && !finishing_ && !streams;
  const int status = response.status;
  std::size_t bytes = head_only ? 0 : response.body.size();
  bool written = true;
  if (streams) {
    bytes = co_await stream(*request, std::move(response));
  } else {
    written = co_await write(response, head_only, open);
  }
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  spdlog::info("request={} peer={} method={} target={} status={} bytes={} ms={:.2f}", id, peer_, method,
               target, status, bytes, taken.count());
  co_return written&& open;
}

bool Session::goes_to_disk(const Head& head) const {
  if (!share_.streaming.wanted) return false;
  const auto target = head.get().target();
  const auto parsed = routes::parse_target({target.data(), target.size()});
  return parsed && share_.streaming.wanted(std::string{head.get().method_string()}, parsed->path);
}

net::awaitable<error_code> Session::read_head(Head& head) {
  error_code error;
  if (buffer_.size() == 0) {
    idle_ = true;
    constexpr std::size_t first_read = 4096;
    stream_.expires_after(share_.limits.idle_time);
    const std::size_t n = co_await stream_.async_read_some(buffer_.prepare(first_read),
                                                           net::redirect_error(net::use_awaitable, error));
    buffer_.commit(n);
    if (error) co_return error == net::error::eof ? error_code{beast::http::error::end_of_stream} : error;
  }
  idle_ = false;
  stream_.expires_after(share_.limits.header_time);
  co_await beast::http::async_read_header(stream_, buffer_, head,
                                          net::redirect_error(net::use_awaitable, error));
  if (error || head.is_done()) co_return error;

  const auto length = head.content_length();
  const std::uint64_t most = goes_to_disk(head) ? share_.streaming.most_bytes : share_.limits.body_bytes;
  if (length && *length > most) co_return beast::http::error::body_limit;
  if (beast::iequals(head.get()[beast::http::field::expect], "100-continue")) {
    beast::http::response<beast::http::empty_body> go_on{beast::http::status::continue_, 11};
    stream_.expires_after(share_.limits.write_time);
    co_await beast::http::async_write(stream_, go_on, net::redirect_error(net::use_awaitable, error));
  }
  co_return error;
}

net::awaitable<error_code> Session::receive(Head& head, bool to_disk, Request& body,
                                            std::optional<BodySink>& sink) {
  if (!to_disk) co_return co_await read_body(head, body);
  try {
    sink.emplace(share_.streaming.folder);
  } catch (const std::system_error& closed) {
    spdlog::error("peer={} {}", peer_, closed.what());
    co_return error_code{closed.code().value(), boost::system::generic_category()};
  }
  co_return co_await stream_body(head, *sink);
}

net::awaitable<error_code> Session::read_body(Head& head, Request& request) {
  error_code error;
  beast::http::request_parser<beast::http::string_body> parser{std::move(head)};
  parser.body_limit(share_.limits.body_bytes);
  if (!parser.is_done()) {
    stream_.expires_after(share_.limits.body_time);
    co_await beast::http::async_read(stream_, buffer_, parser,
                                     net::redirect_error(net::use_awaitable, error));
  }
  request.body = std::move(parser.get().body());
  co_return error;
}

/// Never holds more than one block of the body.
net::awaitable<error_code> Session::stream_body(Head& head, BodySink& sink) {
  constexpr std::size_t block_bytes = 65'536;
  std::vector<char> block(block_bytes);
  beast::http::request_parser<beast::http::buffer_body> parser{std::move(head)};
  parser.body_limit(share_.streaming.most_bytes);
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

/// Runs on a thread of the handlers: a slow disk holds up nobody else's bytes.
net::awaitable<error_code> Session::store(BodySink& sink, std::string_view bytes) {
  try {
    sink.add(bytes);
  } catch (const std::system_error& full) {
    spdlog::error("peer={} {}", peer_, full.what());
    co_return error_code{full.code().value(), boost::system::generic_category()};
  }
  co_return error_code{};
}

net::awaitable<Response> Session::answer(Request& request) {
  Response response =
      co_await net::co_spawn(share_.pool.get_executor(), answer_on_pool(request), net::use_awaitable);
  if (response.wait && !response.streams) {
    routes::Wait wait = std::move(*response.wait);
    response = co_await wait_and_answer(request, std::move(wait));
  }
  co_return response;
}

net::awaitable<Response> Session::answer_on_pool(const Request& request) {
  try {
    co_return finish_response(request, share_.handler(request));
  } catch (const std::exception& error) {
    spdlog::error("method={} path={} failed: {}", request.method, request.path, error.what());
  }
  co_return problem(500, "internal-error", "Internal error",
                    "The server could not answer; its log says why. The request may be sent again.");
}

/// Asks the handler again after every wake-up until it has an answer; at the end of its time it must have
/// one.
net::awaitable<Response> Session::wait_and_answer(Request& request, routes::Wait wait) {
  const auto executor = co_await net::this_coro::executor;
  auto timer = std::make_shared<net::steady_timer>(executor);
  const auto deadline =
      std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::milliseconds>(wait.at_most);
  auto woken = std::make_shared<bool>(false);
  const auto subscription = wait.subscribe([executor, timer, woken] {
    net::post(executor, [timer, woken] {
      *woken = true;
      timer->cancel();
    });
  });
  while (true) {
    const bool last = finishing_ || std::chrono::steady_clock::now() >= deadline;
    *woken = false;
    request.resumption = routes::Resumption{wait.token, last};
    request.now = now();
    Response response =
        co_await net::co_spawn(share_.pool.get_executor(), answer_on_pool(request), net::use_awaitable);
    if (!response.wait || last) co_return response;
    if (*woken) continue;
    error_code ignored;
    constexpr std::chrono::seconds look_again{1};  // also notices that the server stops
    timer->expires_at(std::min(deadline, std::chrono::steady_clock::now() + look_again));
    co_await timer->async_wait(net::redirect_error(net::use_awaitable, ignored));
  }
}

net::awaitable<bool> Session::write(const Response& response, bool head_only, bool keep_alive) {
  beast::http::response<beast::http::string_body> message;
  message.version(11);
  message.result(static_cast<unsigned>(response.status));
  if (!response.content_type.empty()) message.set(beast::http::field::content_type, response.content_type);
  for (const auto& [name, value] : response.headers) message.insert(name, value);
  message.keep_alive(keep_alive);
  const bool bodiless = response.status == 204 || response.status == 304;
  if (!bodiless) message.content_length(response.body.size());
  if (!head_only) message.body() = response.body;

  error_code error;
  stream_.expires_after(share_.limits.write_time);
  co_await beast::http::async_write(stream_, message, net::redirect_error(net::use_awaitable, error));
  co_return !error;
}

/// Says what was wrong with a request that could not be read, if there is somebody to tell.
net::awaitable<void> Session::refuse(error_code fault, std::uint64_t most_bytes) {
  using beast::http::error;
  const bool disk_failed = fault.category() == boost::system::generic_category();
  const bool http_fault =
      disk_failed || fault.category() == beast::http::make_error_code(error::end_of_stream).category();
  if (!http_fault || fault == error::end_of_stream || fault == error::partial_message) co_return;
  Response response =
      problem(400, "invalid-request", "Invalid request", "The request is not valid HTTP/1.1.");
  if (fault == error::header_limit) {
    response = problem(431, "header-too-large", "Header too large", "The header is larger than 16 KiB.");
  } else if (fault == error::body_limit) {
    response = problem(413, "body-too-large", "Body too large",
                       "The body is larger than " + std::to_string(most_bytes >> 20U) + " MiB.");
  }
  if (disk_failed)
    response = problem(507, "insufficient-storage", "Insufficient storage",
                       "The server cannot write the body to its disk.");
  spdlog::info("peer={} status={} reason=\"{}\"", peer_, response.status, fault.message());
  co_await write(response, false, false);
  co_await linger();
}

/// Reads on for a moment: closing on unread data would reset the connection before the client has read its
/// answer.
net::awaitable<void> Session::linger() {
  error_code error;
  stream_.socket().shutdown(net::ip::tcp::socket::shutdown_send, error);
  constexpr std::size_t most = 8 * 1024 * 1024;
  std::size_t total = 0;
  stream_.expires_after(std::chrono::seconds{2});
  while (!error && total < most) {
    buffer_.clear();
    total += co_await stream_.async_read_some(buffer_.prepare(65536),
                                              net::redirect_error(net::use_awaitable, error));
  }
}

}  // namespace floeplan::http

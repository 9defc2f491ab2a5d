#include "server/http/session.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <new>
#include <optional>
#include <random>
#include <sstream>
#include <vector>

#include "api/log/log.hpp"
#include "engine/core/shown_text.hpp"
#include "server/http/finish_response.hpp"
#include "server/http/refusals.hpp"
#include "server/http/request_head.hpp"
#include "server/http/tls_context.hpp"

namespace floeplan::http {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
using beast::error_code;
using routes::Request;
using routes::Response;


/// An id that is unique in this process, and in practice among all processes.
std::string next_request_id() {
  static const std::string process = [] {
    std::ostringstream text;
    text << std::hex << std::random_device{}();
    return text.str();
  }();
  static std::atomic<std::uint64_t> last{0};
  return process + "-" + std::to_string(++last);
}

Response internal_error() { return problem_response(problems::problem<"internal-error">()); }

Response come_again(Response response) {
  response.headers.emplace_back("Retry-After", "30");
  return response;
}

Response too_many_streams() { return come_again(problem_response(problems::problem<"too-many-streams">())); }

Response too_many_streams_of_client(std::size_t most) {
  return come_again(problem_response(problems::problem<"too-many-streams-of-client">(most)));
}

Response too_many_files(std::size_t most) {
  return come_again(problem_response(problems::problem<"too-many-files">(most)));
}

/// The status line and the headers as one buffer. Beast's serializer would pass each header as four buffers
/// to the system; gathering about fifty of them costs more than copying a few hundred bytes.
std::string head_of(const Response& response, bool keep_alive, bool https_only) {
  beast::http::response<beast::http::empty_body> message;
  message.version(11);
  message.result(static_cast<unsigned>(response.status));
  if (!response.content_type.empty()) message.set(beast::http::field::content_type, response.content_type);
  for (const auto& [name, value] : response.headers) message.insert(name, value);
  if (https_only) message.insert("Strict-Transport-Security", https_only_for_a_year);
  message.keep_alive(keep_alive);
  const bool bodiless = response.status == 204 || response.status == 304;
  if (!bodiless) message.content_length(response.body.size());

  std::string text;
  beast::http::response_serializer<beast::http::empty_body> serializer{message};
  error_code never;  // the request head is already in memory, so reading it cannot fail
  serializer.next(never, [&](error_code&, const auto& buffers) { text = beast::buffers_to_string(buffers); });
  return text;
}

/// The result of `work`, or the response for the client if it throws.
template <class Result, class Work>
Result or_problem(const Request& request, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    log::error({"method=", request.method, " path=", core::shown_target(request.path), " failed: no memory"});
    return busy();
  } catch (const std::exception& error) {
    log::error(
        {"method=", request.method, " path=", core::shown_target(request.path), " failed: ", error.what()});
  }
  return internal_error();
}

}  // namespace

SessionShare::SessionShare(routes::Handler answer, Limits bounds, Equipment tools, std::size_t threads)
    : handler{std::move(answer)},
      limits{bounds},
      equipment{std::move(tools)},
      tls{equipment.tls ? make_tls_context(*equipment.tls) : nullptr},
      memory{bounds.held_bytes},
      pool{threads},
      line{threads} {}

std::string SessionShare::client_of(const Request& request) const {
  return equipment.client_of ? equipment.client_of(request) : request.peer;
}

Session::Session(net::ip::tcp::socket socket, SessionShare& share)
    : stream_{std::move(socket), share.tls}, share_{share} {
  error_code ignored;
  stream_.socket().set_option(net::ip::tcp::no_delay{true}, ignored);
  const auto endpoint = stream_.socket().remote_endpoint(ignored);
  peer_ = endpoint.address().to_string(ignored);
  wait_for_client();
}

Session::~Session() { stop_waiting(); }

void Session::wait_for_client() {
  stop_waiting();
  waiting_ = share_.waiting.enter(*this, peer_);
}

void Session::stop_waiting() {
  if (waiting_) share_.waiting.leave(*waiting_, peer_);
  waiting_.reset();
}

net::awaitable<void> Session::run() {
  stream_.expires_after(share_.limits.first_byte_time);
  const error_code closed = co_await stream_.open();
  if (closed) co_return;
  while (!finishing_ && co_await exchange()) {
  }
  wait_for_client();
  co_await stream_.end();
}

void Session::drop() {
  finishing_ = true;
  stop_waiting();
  stream_.cancel();
}

void Session::finish() {
  finishing_ = true;
  if (idle_) stream_.cancel();
}

/// Reads one request and answers it. False: the connection must be closed.
net::awaitable<bool> Session::exchange() {
  wait_for_client();
  Head head;
  head.header_limit(share_.limits.header_bytes);
  head.body_limit(std::max(share_.limits.body_bytes, share_.equipment.streaming.most_bytes));
  error_code error = co_await read_head(head);
  idle_ = false;
  const bool to_disk = goes_to_disk(head);
  const std::string method{head.get().method_string()};
  const auto sent_target = head.get().target();
  const std::string target = core::shown_target({sent_target.data(), sent_target.size()});
  const bool head_only = head.get().method() == beast::http::verb::head;
  const bool keep_alive = !error && head.keep_alive();
  std::optional<Request> request;
  std::optional<ClientCounts::One> counted;  // until the whole body was received; likewise `part`
  std::optional<BodySink> sink;
  Request body;
  if (!error) request = to_request(head.get());
  if (request && to_disk) {
    auto refusal = co_await ask_doors(*request);
    const std::string client = share_.client_of(*request);
    if (!refusal && share_.files.of(client) >= share_.limits.files_of_client)
      refusal = too_many_files(share_.limits.files_of_client);
    if (!refusal) counted.emplace(share_.files, client);
    if (refusal) {
      co_await write(*refusal, head_only, false);
      co_await linger();
      co_return false;
    }
  }
  if (!error) error = co_await receive(head, to_disk, body, sink);
  if (error) {
    sink.reset();  // removed already while the client reads the refusal
    co_await refuse(error, target.empty(),
                    to_disk ? share_.equipment.streaming.most_bytes : share_.limits.body_bytes);
    co_return false;
  }

  stop_waiting();
  const auto begin = std::chrono::steady_clock::now();
  const std::string id = next_request_id();
  Response response;
  if (!share_.memory.has(0)) {
    response = busy();
  } else if (request) {
    request->body = std::move(body.body);
    if (sink) request->body_file = sink->finish();
    request->id = id;
    request->peer = peer_;
    response = co_await answer(*request);
  } else {
    response = problem_response(problems::problem<"invalid-target">());
  }
  response.headers.emplace_back("X-Request-Id", id);
  if (response.streams && !head_only) {
    const std::size_t most_of_client = share_.limits.streams_of_client;
    if (share_.streams.all() >= share_.limits.streams) {
      response = too_many_streams();
    } else if (share_.streams.of(share_.client_of(*request)) >= most_of_client) {
      response = too_many_streams_of_client(most_of_client);
    }
  }
  const bool streams = response.streams && !head_only;
  const bool open = keep_alive && !finishing_ && !streams;
  const int status = response.status;
  const std::string route = response.route;
  const std::string caller = response.caller.empty() ? "-" : response.caller;
  std::uint64_t bytes = head_only ? 0 : response.body.size();
  bool written = true;
  if (streams) {
    bytes = co_await stream(*request, std::move(response));
  } else {
    written = co_await write(response, head_only, open);
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  log::info({"request=", id, " peer=", peer_, " caller=", caller, " method=", method, " target=", target,
             " status=", std::to_string(status), " bytes=", std::to_string(bytes),
             " ms=", log::decimals(1000.0 * taken.count(), 2)});
  if (share_.equipment.observe && !streams) share_.equipment.observe({method, route, status, taken, bytes});
  co_return written&& open;
}

/// Asks before a body is read whether the caller may send it, so that others cannot fill the disk.
net::awaitable<std::optional<Response>> Session::ask_doors(Request& request) {
  if (!share_.equipment.streaming.refuse) co_return std::nullopt;
  request.peer = peer_;
  const std::function<std::optional<Response>()> ask = [&] {
    return or_problem<std::optional<Response>>(request,
                                               [&] { return share_.equipment.streaming.refuse(request); });
  };
  auto refusal = co_await in_turn(request, ask);
  if (refusal) refusal = finish_response(request, std::move(*refusal));
  co_return refusal;
}

net::awaitable<Response> Session::answer(Request& request) {
  Response response;
  if (auto known = ask_at_once(request)) {
    response = std::move(*known);
  } else {
    response = co_await answer_in_turn(request);
  }
  if (response.wait && !response.streams) {
    routes::Wait wait = std::move(*response.wait);
    response = co_await wait_and_answer(request, std::move(wait));
  }
  co_return response;
}

/// Runs `work` on a thread of the pool when it is the client's turn, and returns its result.
template <class Result>
net::awaitable<Result> Session::in_turn(const Request& request, std::function<Result()> work) {
  const auto executor = co_await net::this_coro::executor;
  net::steady_timer turn{executor, net::steady_timer::time_point::max()};
  const FairLine::Place place{share_.line, share_.client_of(request), [&turn] { turn.cancel(); }};
  error_code ignored;
  if (!place.has_begun()) co_await turn.async_wait(net::redirect_error(net::use_awaitable, ignored));
  const auto on_pool = [&work]() -> net::awaitable<Result> { co_return work(); };
  co_return co_await net::co_spawn(share_.pool.get_executor(), on_pool, net::use_awaitable);
}

net::awaitable<Response> Session::answer_in_turn(const Request& request) {
  return in_turn(request, std::function<Response()>{[this, &request] { return ask_handler(request); }});
}

Response Session::ask_handler(const Request& request) {
  return or_problem<Response>(request, [&] { return finish_response(request, share_.handler(request)); });
}

std::optional<Response> Session::ask_at_once(const Request& request) {
  if (!share_.equipment.at_once) return std::nullopt;
  return or_problem<std::optional<Response>>(request, [&] {
    auto known = share_.equipment.at_once(request);
    if (known) known = finish_response(request, std::move(*known));
    return known;
  });
}

/// Calls the handler again after each wake-up until it answers. When the time is up it must answer.
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
      Response response = co_await answer_in_turn(request);
    if (!response.wait || last) co_return response;
    if (*woken) continue;
    error_code ignored;
    constexpr std::chrono::seconds look_again{1};  // also detects that the server stops
    timer->expires_at(std::min(deadline, std::chrono::steady_clock::now() + look_again));
    co_await timer->async_wait(net::redirect_error(net::use_awaitable, ignored));
  }
}

net::awaitable<bool> Session::write(const Response& response, bool head_only, bool keep_alive) {
  const MemoryBudget::Part part{share_.memory, response.body.size()};
  const std::string head = head_of(response, keep_alive, share_.equipment.https_only);
  const std::string no_body;
  const std::array<net::const_buffer, 2> pieces{net::buffer(head),
                                                net::buffer(head_only ? no_body : response.body)};

  error_code error;
  wait_for_client();
  stream_.expires_after(share_.limits.write_time);
  co_await net::async_write(stream_, pieces, net::redirect_error(net::use_awaitable, error));
  co_return !error;
}

/// Answers a request that could not be read with the reason, if the connection is still open.
net::awaitable<void> Session::refuse(error_code fault, bool in_first_line, std::uint64_t most_bytes) {
  const auto response = refusal_of(fault, in_first_line, most_bytes);
  if (!response) co_return;
  log::info(
      {"peer=", peer_, " status=", std::to_string(response->status), " reason=\"", fault.message(), "\""});
  co_await write(*response, false, false);
  co_await linger();
}

/// Continues to read for a moment. Closing with unread data would reset the connection before the client has
/// read the answer.
net::awaitable<void> Session::linger() {
  error_code error;
  wait_for_client();
  stream_.stop_sending();
  constexpr std::size_t most = 8UL * 1024 * 1024;
  std::size_t total = 0;
  stream_.expires_after(std::chrono::seconds{2});
  while (!error && total < most) {
    buffer_.clear();
    total += co_await stream_.async_read_some(buffer_.prepare(65536),
                                              net::redirect_error(net::use_awaitable, error));
  }
}

}  // namespace floeplan::http

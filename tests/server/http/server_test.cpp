#include "server/http/server.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/read_until.hpp>
#include <condition_variable>
#include <list>
#include <memory>
#include <mutex>
#include <new>
#include <thread>

#include "tests/server/http/running_server.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::http::server_test {
namespace {

using support::echo;
using support::get;
using support::RunningServer;

TEST(Server, AnswersWithTheDecodedRequest) {
  RunningServer server{echo};
  const auto answer = server.exchange(get("/a%20b?x=1"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n")) << answer;
  EXPECT_TRUE(answer.ends_with("GET /a b ")) << answer;
}

TEST(Server, KeepsTheConnectionForTheNextRequest) {
  RunningServer server{echo};
  const auto answer = server.exchange("GET /1 HTTP/1.1\r\nHost: x\r\n\r\n" + get("/2"));
  EXPECT_NE(answer.find("GET /1 "), std::string::npos);
  EXPECT_NE(answer.find("GET /2 "), std::string::npos);
}

TEST(Server, AnswersHeadWithoutBodyButWithItsLength) {
  RunningServer server{echo};
  const auto answer = server.exchange("HEAD /x HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n");
  EXPECT_NE(answer.find("Content-Length: 8\r\n"), std::string::npos) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\n"));
}

TEST(Server, RefusesAHeaderThatIsTooLarge) {
  RunningServer server{echo};
  const auto answer = server.exchange(get("/", "X-Long: " + std::string(20'000, 'a') + "\r\n"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 431")) << answer.substr(0, 100);
}

TEST(Server, RefusesABodyThatIsTooLarge) {
  RunningServer server{echo};
  const std::string body(2'000'000, '[');
  const auto answer =
      server.exchange("POST / HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\nContent-Length: " +
                      std::to_string(body.size()) + "\r\n\r\n" + body);
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 413")) << answer.substr(0, 100);
}

TEST(Server, RefusesWhatIsNotHttpAndBadPercentSigns) {
  RunningServer server{echo};
  EXPECT_TRUE(server.exchange("nonsense\r\n\r\n").starts_with("HTTP/1.1 400"));
  EXPECT_TRUE(server.exchange(get("/%zz")).starts_with("HTTP/1.1 400"));
}

TEST(Server, AnswersAProblemWhenAHandlerThrows) {
  RunningServer server{
      [](const routes::Request&) -> routes::Response { throw std::runtime_error{"secret"}; }};
  const auto answer = server.exchange(get("/"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 500"));
  EXPECT_EQ(answer.find("secret"), std::string::npos);
}

TEST(Server, AnswersAtOnceWhatItIsToldTo) {
  const auto thread_of_handler = [](const routes::Request&) {
    routes::Response response;
    response.body = std::to_string(std::hash<std::thread::id>{}(std::this_thread::get_id()));
    return response;
  };
  std::string io_thread;
  RunningServer server{thread_of_handler, {}, {.at_once = [&](const routes::Request& request) {
                         io_thread = std::to_string(std::hash<std::thread::id>{}(std::this_thread::get_id()));
                         return request.path == "/quick" ? std::optional{thread_of_handler(request)}
                                                         : std::nullopt;
                       }}};
  EXPECT_TRUE(server.exchange(get("/quick")).ends_with("\r\n" + io_thread));
  EXPECT_FALSE(server.exchange(get("/slow")).ends_with("\r\n" + io_thread));
}

TEST(Server, AsksToComeAgainWhenAHandlerFindsNoMemory) {
  RunningServer server{[](const routes::Request&) -> routes::Response { throw std::bad_alloc{}; }};
  const auto answer = server.exchange(get("/"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 503"));
  EXPECT_NE(answer.find("Retry-After: 5"), std::string::npos);
}

TEST(Server, AsksAWaitingHandlerAgainWhenItIsWoken) {
  std::mutex mutex;
  std::function<void()> wake;
  std::atomic<int> calls{0};
  RunningServer server{[&](const routes::Request& request) {
    if (++calls == 2) {  // the first call after the subscription: from now on a wake-up is heard
      const std::lock_guard lock{mutex};
      wake();
    }
    if (calls >= 3) return echo(request);
    routes::Response response;
    response.wait = routes::Wait{core::Seconds{60.0}, "token", [&](std::function<void()> wake_up) {
                                   const std::lock_guard lock{mutex};
                                   wake = std::move(wake_up);
                                   return std::make_shared<int>(0);
                                 }};
    return response;
  }};
  EXPECT_TRUE(server.exchange(get("/later")).starts_with("HTTP/1.1 200"));
}

/// Streams the numbers up to three, a new one after each wake-up or timeout.
routes::Response count(const routes::Request& request) {
  routes::Response response;
  response.content_type = "text/event-stream";
  response.streams = true;
  const int number = request.resumption ? std::stoi(request.resumption->token) + 1 : 1;
  response.body = std::to_string(number);
  if (number < 3) {
    response.wait =
        routes::Wait{core::Seconds{0.01}, response.body, [](std::function<void()>) { return nullptr; }};
  }
  return response;
}

TEST(Server, SendsTheBodyOfAStreamPieceByPieceAndEndsIt) {
  RunningServer server{count};
  const auto answer = server.exchange("GET /events HTTP/1.1\r\nHost: x\r\n\r\n");
  EXPECT_NE(answer.find("Transfer-Encoding: chunked\r\n"), std::string::npos) << answer;
  EXPECT_EQ(answer.find("ETag"), std::string::npos) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\n1\r\n1\r\n1\r\n2\r\n1\r\n3\r\n0\r\n\r\n")) << answer;
}

TEST(Server, RefusesMoreStreamsThanItMayHold) {
  Limits limits;
  limits.streams = 0;
  RunningServer server{count, limits};
  const auto answer = server.exchange(get("/events"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 503")) << answer;
  EXPECT_NE(answer.find("Retry-After: 30\r\n"), std::string::npos);
}

/// A request of a client on its own connection.
class Asking {
 public:
  Asking(const RunningServer& server, const std::string& target, const std::string& client) {
    socket_.connect(server.endpoint());
    boost::asio::write(socket_, boost::asio::buffer(get(target, "X-Client: " + client + "\r\n")));
  }
  std::string answer() { return RunningServer::exchange(socket_, ""); }
  /// Waits for the first line of the answer.
  std::string first_line() {
    boost::asio::read_until(socket_, boost::asio::dynamic_buffer(begin_), "\r\n");
    return begin_.substr(0, begin_.find('\r'));
  }

 private:
  boost::asio::io_context io_;
  boost::asio::ip::tcp::socket socket_{io_};
  std::string begin_;
};

Equipment clients_by_header() {
  Equipment equipment;
  equipment.client_of = [](const routes::Request& request) { return request.header("x-client"); };
  return equipment;
}

TEST(Server, AnswersAnotherClientWhileOneKeepsItsHandlersBusy) {
  std::mutex mutex;
  std::condition_variable changed;
  bool released = false;
  int busy = 0;
  const auto handler = [&](const routes::Request& request) {
    if (request.path == "/slow") {
      std::unique_lock lock{mutex};
      ++busy;
      changed.notify_all();
      changed.wait(lock, [&] { return released; });
    }
    return echo(request);
  };
  RunningServer server{handler, {}, clients_by_header()};
  std::list<Asking> slow;
  for (int i = 0; i < 8; ++i) slow.emplace_back(server, "/slow", "ann");
  {
    std::unique_lock lock{mutex};
    changed.wait(lock, [&] { return busy > 0; });
  }

  for (int i = 0; i < 5; ++i)
    EXPECT_TRUE(Asking(server, "/quick", "bob").answer().starts_with("HTTP/1.1 200"));

  {
    const std::lock_guard lock{mutex};
    EXPECT_EQ(busy, 1) << "of ann's, who never has both handlers";
    released = true;
  }
  changed.notify_all();
  for (Asking& one : slow) EXPECT_TRUE(one.answer().starts_with("HTTP/1.1 200"));
}

TEST(Server, StopsWhileRequestsWaitForTheirTurn) {
  std::mutex mutex;
  std::condition_variable changed;
  bool released = false;
  int busy = 0;
  const auto handler = [&](const routes::Request& request) {
    std::unique_lock lock{mutex};
    ++busy;
    changed.notify_all();
    changed.wait(lock, [&] { return released; });
    return echo(request);
  };
  Limits limits;
  limits.stop_time = std::chrono::seconds{0};
  auto server = std::make_unique<RunningServer>(handler, limits, clients_by_header());
  std::list<Asking> slow;
  for (const char* client : {"ann", "ann", "ann", "bob", "bob", "cy"})
    slow.emplace_back(*server, "/slow", client);
  {
    std::unique_lock lock{mutex};
    changed.wait(lock, [&] { return busy == 2; });
  }

  std::jthread stopping{[&] { server.reset(); }};
  {
    const std::lock_guard lock{mutex};
    released = true;
  }
  changed.notify_all();
  stopping.join();

  for (Asking& one : slow) {
    const std::string answer = one.answer();  // ends, because its connection did
    EXPECT_TRUE(answer.empty() || answer.starts_with("HTTP/1.1 200")) << answer;
  }
}

TEST(Server, LeavesStreamsForOtherClients) {
  const auto endless = [](const routes::Request&) {
    routes::Response response;
    response.content_type = "text/event-stream";
    response.streams = true;
    response.body = "1";
    response.wait = routes::Wait{core::Seconds{60.0}, "", [](std::function<void()>) { return nullptr; }};
    return response;
  };
  Limits limits;
  limits.streams_of_client = 2;
  RunningServer server{endless, limits, clients_by_header()};
  std::list<Asking> streams;
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(streams.emplace_back(server, "/events", "ann").first_line(), "HTTP/1.1 200 OK");

  const std::string refused = Asking(server, "/events", "ann").answer();
  EXPECT_TRUE(refused.starts_with("HTTP/1.1 429")) << refused;
  EXPECT_NE(refused.find("Retry-After: 30\r\n"), std::string::npos) << refused;
  EXPECT_NE(refused.find("You have 2 event streams open"), std::string::npos) << refused;

  EXPECT_EQ(streams.emplace_back(server, "/events", "bob").first_line(), "HTTP/1.1 200 OK");
}

TEST(Server, TakesInSoManyFilesOfOneClientAtOnce) {
  const support::TemporaryFolder folder;
  Equipment equipment = clients_by_header();
  equipment.streaming = {[](const std::string& method, const std::string&) { return method == "POST"; },
                         folder.path() / "files", 4'000'000};
  Limits limits;
  limits.files_of_client = 1;
  RunningServer server{echo, limits, equipment};
  const std::string half_sent =
      "POST /file HTTP/1.1\r\nHost: x\r\nX-Client: ann\r\nExpect: 100-continue\r\n"
      "Connection: close\r\nContent-Length: 4\r\n\r\n";
  boost::asio::io_context io;
  boost::asio::ip::tcp::socket first{io};
  first.connect(server.endpoint());
  boost::asio::write(first, boost::asio::buffer(half_sent));
  std::string invited;
  boost::asio::read_until(first, boost::asio::dynamic_buffer(invited), "100 Continue\r\n\r\n");

  EXPECT_TRUE(server.exchange(half_sent).starts_with("HTTP/1.1 429"));
  EXPECT_TRUE(RunningServer::exchange(first, "data").starts_with("HTTP/1.1 200"));
  EXPECT_TRUE(server.exchange(half_sent + "data").find("HTTP/1.1 200") != std::string::npos);
}

TEST(Server, TellsTheHandlerWhenTheTimeToWaitIsOver) {
  RunningServer server{[](const routes::Request& request) {
    if (request.resumption && request.resumption->last) return echo(request);
    routes::Response response;
    response.wait = routes::Wait{core::Seconds{0.05}, "", [](std::function<void()>) { return nullptr; }};
    return response;
  }};
  EXPECT_TRUE(server.exchange(get("/late")).starts_with("HTTP/1.1 200"));
}

}  // namespace
}  // namespace floeplan::http::server_test

#include "server/http/server.hpp"

#include <atomic>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <csignal>
#include <map>
#include <stdexcept>
#include <unordered_set>

#include "api/log/log.hpp"
#include "engine/messages/command_messages.hpp"
#include "server/http/session.hpp"
#include "server/http/tls_context.hpp"

namespace floeplan::http {

namespace net = boost::asio;

/// The listener's state; everything but the constructor runs on the I/O thread.
class Server::Listener {
 public:
  Listener(const ListenAddress& address, routes::Handler handler, std::size_t handler_threads, Limits limits,
           Equipment equipment)
      : share_{std::move(handler), limits, std::move(equipment), handler_threads} {
    const net::ip::tcp::endpoint endpoint{net::ip::make_address(address.host), address.port};
    boost::system::error_code error;
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(net::socket_base::reuse_address{true});
    acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(net::socket_base::max_listen_connections, error);
    if (error) {
      throw std::runtime_error{messages::command_text<"address-not-listened-on">(
          address.host + ":" + std::to_string(address.port), error.message())};
    }
  }

  ~Listener() { share_.pool.join(); }

  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

  [[nodiscard]] std::size_t connections() const { return open_; }

  void run() {
    signals_.async_wait([this](const boost::system::error_code& error, int signal) {
      if (error) return;
      log::info({"signal=", std::to_string(signal), " the server stops"});
      finish();
    });
    wait_for_hangup();
    net::co_spawn(io_, accept(), net::detached);
    io_.run();
    share_.pool.join();
  }

  void stop() {
    net::post(io_, [this] { finish(); });
  }

  void reload() {
    net::post(io_, [this] { take_new_settings(); });
  }

 private:
  using SessionsOfPeer = std::unordered_set<Session*>;  // borrowed; each session lives in its coroutine

  void wait_for_hangup() {
    hangups_.async_wait([this](const boost::system::error_code& error, int) {
      if (error) return;
      take_new_settings();
      wait_for_hangup();
    });
  }

  /// Applies all new settings, or none.
  void take_new_settings() {
    try {
      Equipment& equipment = share_.equipment;
      const Settings settings =
          equipment.settings ? equipment.settings() : Settings{share_.limits,
                                                               equipment.streaming.most_bytes,
                                                               equipment.tls,
                                                               equipment.https_only,
                                                               {},
                                                               {}};
      if (settings.tls.has_value() != (share_.tls != nullptr))
        throw std::runtime_error{messages::command_text<"tls-not-switched">()};
      if (settings.tls) share_.tls = make_tls_context(*settings.tls);
      share_.limits = settings.limits;
      equipment.streaming.most_bytes = settings.most_upload_bytes;
      equipment.tls = settings.tls;
      equipment.https_only = settings.https_only;
      if (settings.taken) settings.taken();
      log::info({"reload=done certificate, limits, quotas and log level are those of now"});
      if (!settings.log_level.empty()) log::set_level(settings.log_level);
    } catch (const std::exception& error) {
      log::error({"reload=refused everything stays as it was: ", error.what()});
    }
  }

  net::awaitable<void> accept() {
    while (acceptor_.is_open()) {
      boost::system::error_code error;
      auto socket = co_await acceptor_.async_accept(net::redirect_error(net::use_awaitable, error));
      if (error == net::error::operation_aborted) co_return;
      if (error) {
        co_await pause();  // probably no free file descriptor; waits until some connections end
        continue;
      }
      if (!make_room(address_of(socket))) continue;  // refused; the socket is closed here
      net::co_spawn(io_, serve(std::move(socket)), net::detached);
    }
  }

  static std::string address_of(const net::ip::tcp::socket& socket) {
    boost::system::error_code ignored;
    return socket.remote_endpoint(ignored).address().to_string(ignored);
  }

  /// Closes a waiting connection. False if all have running requests.
  bool make_room(const std::string& peer) {
    const auto of_peer = sessions_.find(peer);
    if (of_peer != sessions_.end() && of_peer->second.size() >= share_.limits.connections_per_address)
      return drop(share_.waiting.first_of(peer));
    return open_ < share_.limits.connections || drop(share_.waiting.first());
  }

  static bool drop(Session* longest_waiting) {
    if (longest_waiting != nullptr) longest_waiting->drop();
    return longest_waiting != nullptr;
  }

  net::awaitable<void> pause() {
    boost::system::error_code ignored;
    net::steady_timer timer{io_, std::chrono::milliseconds{100}};
    co_await timer.async_wait(net::redirect_error(net::use_awaitable, ignored));
  }

  net::awaitable<void> serve(net::ip::tcp::socket socket) {
    const auto session = std::make_unique<Session>(std::move(socket), share_);
    const std::string peer = session->peer();
    sessions_[peer].insert(session.get());
    ++open_;
    try {
      co_await session->run();
    } catch (const std::exception& error) {
      log::error({"a connection broke off: ", error.what()});
    }
    sessions_[peer].erase(session.get());
    if (sessions_[peer].empty()) sessions_.erase(peer);
    --open_;
    if (finishing_ && sessions_.empty()) deadline_.cancel();
  }

  /// Accepts no new connections and requests; running requests are answered until the deadline.
  void finish() {
    if (finishing_) return;
    finishing_ = true;
    boost::system::error_code ignored;
    acceptor_.close(ignored);
    signals_.cancel(ignored);
    hangups_.cancel(ignored);
    for (const auto& [peer, sessions] : sessions_)
      for (Session* session : sessions) session->finish();
    if (sessions_.empty()) return;
    deadline_.expires_after(share_.limits.stop_time);
    deadline_.async_wait([this](const boost::system::error_code& error) {
      if (!error) io_.stop();
    });
  }

  SessionShare share_;
  std::map<std::string, SessionsOfPeer> sessions_;  // sessions by the client's address
  std::atomic<std::size_t> open_{0};
  bool finishing_{false};
  net::io_context io_{1};
  net::ip::tcp::acceptor acceptor_{io_};
  net::signal_set signals_{io_, SIGINT, SIGTERM};
  net::signal_set hangups_{io_, SIGHUP};
  net::steady_timer deadline_{io_};
};

Server::Server(const ListenAddress& address, routes::Handler handler, std::size_t handler_threads,
               Limits limits, Equipment equipment)
    : listener_{std::make_unique<Listener>(address, std::move(handler), handler_threads, limits,
                                           std::move(equipment))} {}

Server::~Server() = default;

std::uint16_t Server::port() const { return listener_->port(); }

std::size_t Server::connections() const { return listener_->connections(); }

void Server::run() { listener_->run(); }

void Server::stop() { listener_->stop(); }

void Server::reload() { listener_->reload(); }

}  // namespace floeplan::http

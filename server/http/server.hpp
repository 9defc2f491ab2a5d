#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "api/routes/request/message.hpp"
#include "server/http/listen_address.hpp"
#include "server/http/server_settings.hpp"

namespace floeplan::http {

/// HTTP/1.1 server. One thread (the caller of run) does all input and output. Handlers run on their own
/// threads, except for answers that are available at once. Clients take turns on these threads, and none gets
/// all of them. If there are too many connections, of one address or in all, the one that has waited longest
/// for its client is closed. Connections with a running request are never closed; if there are no others, the
/// new connection is refused.
/// Errors   std::runtime_error from the constructor when it cannot listen on the address or the certificate
///          is invalid
class Server {
 public:
  Server(const ListenAddress& address, routes::Handler handler, std::size_t handler_threads,
         Limits limits = {}, Equipment equipment = {});
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// The port of the server, also if port 0 was requested.
  [[nodiscard]] std::uint16_t port() const;
  /// Number of open connections. May be called from any thread.
  [[nodiscard]] std::size_t connections() const;
  /// Serves until stop(), SIGTERM or SIGINT. Running requests are answered within `stop_time`.
  void run();
  /// May be called from any thread.
  void stop();
  /// Does the same as SIGHUP: applies new settings and reads the certificate again, for later requests and
  /// connections. If they are invalid, nothing changes and the log says so. May be called from any thread.
  void reload();

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace floeplan::http

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "api/routes/request/message.hpp"
#include "server/http/listen_address.hpp"
#include "server/http/server_settings.hpp"

namespace floeplan::http {

/// HTTP/1.1 listener. One thread (the caller of run) does all input and output; handlers run on threads of
/// their own, except for what is to be answered at once. Clients have them in turn, and none has all of them.
/// When there are too many connections, of one address or in all, the one that has been waiting longest for its client
/// makes room; those that are being answered are never ended, and a new one is refused when there are no others.
/// Errors   std::runtime_error from the constructor when the address cannot be listened on or the certificate not be
///          used
class Server {
 public:
  Server(const ListenAddress& address, routes::Handler handler, std::size_t handler_threads,
         Limits limits = {}, Equipment equipment = {});
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// The port that is listened on, also when 0 was asked for.
  [[nodiscard]] std::uint16_t port() const;
  /// How many connections are open now. May be called from any thread.
  [[nodiscard]] std::size_t connections() const;
  /// Serves until stopped by stop(), SIGTERM or SIGINT. Open requests get their answers within `stop_time`.
  void run();
  /// May be called from any thread.
  void stop();
  /// Does what SIGHUP does: takes new settings and reads the certificate again, for requests and connections that
  /// come after it; those that are open go on. When anything is wrong with them, all stays as it was and the log says
  /// so. May be called from any thread.
  void reload();

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace floeplan::http

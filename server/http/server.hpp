#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "api/routes/message.hpp"
#include "server/http/body_sink.hpp"
#include "server/http/listen_address.hpp"

namespace floeplan::http {

/// Limits that keep one client from taking what all need.
struct Limits {
  std::uint32_t header_bytes{16 * 1024};
  std::uint64_t body_bytes{1024 * 1024};
  std::chrono::seconds header_time{10};  // from the first byte of a request to the end of its header
  std::chrono::seconds body_time{30};    // of one that goes to disk: for each 64 KiB
  std::chrono::seconds idle_time{60};    // between requests
  std::chrono::seconds write_time{60};
  std::chrono::seconds stop_time{8};  // for open requests, when the server stops
  std::size_t connections{1000};
  std::size_t streams{200};  // of events, each on a connection of its own
};

/// HTTP/1.1 listener. One thread (the caller of run) does all input and output; handlers run on threads of
/// their own.
/// Errors   std::runtime_error from the constructor when the address cannot be listened on
class Server {
 public:
  Server(const ListenAddress& address, routes::Handler handler, std::size_t handler_threads,
         Limits limits = {}, Streaming streaming = {});
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// The port that is listened on, also when 0 was asked for.
  [[nodiscard]] std::uint16_t port() const;
  /// Serves until stopped by stop(), SIGTERM or SIGINT. Open requests get their answers within `stop_time`.
  void run();
  /// May be called from any thread.
  void stop();

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

}  // namespace floeplan::http

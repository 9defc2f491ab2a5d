#pragma once

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <stdexcept>

namespace floeplan::support {

/// A listener on 127.0.0.1 that records whether anything has connected.
class LoopbackListener {
 public:
  LoopbackListener() : socket_{socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)} {
    sockaddr_in place{.sin_family = AF_INET, .sin_port = 0, .sin_addr = {}, .sin_zero = {}};
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place;
    auto* const address = reinterpret_cast<sockaddr*>(&place);
    if (bind(socket_, address, size) != 0 || listen(socket_, 8) != 0 ||
        getsockname(socket_, address, &size) != 0)
      throw std::runtime_error{"no listener on loopback"};
    port_ = ntohs(place.sin_port);
  }
  LoopbackListener(const LoopbackListener&) = delete;
  LoopbackListener& operator=(const LoopbackListener&) = delete;
  ~LoopbackListener() { close(socket_); }

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] bool somebody_came() const {
    const int guest = accept(socket_, nullptr, nullptr);
    if (guest >= 0) close(guest);
    return guest >= 0;
  }

 private:
  int socket_;
  std::uint16_t port_{};
};

}  // namespace floeplan::support

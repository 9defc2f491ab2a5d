#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace floeplan::http {

class Session;

/// The connections that wait for their clients, in the order in which they began to wait. The longest wait is
/// found in constant time, so that many connections do not make each new one slower.
/// Threads  the I/O thread alone
class WaitingLine {
 public:
  using Ticket = std::uint64_t;

  /// Adds a session at the end.
  Ticket enter(Session& session, const std::string& peer);
  void leave(Ticket ticket, const std::string& peer);
  /// The first session of the line, and the first of one address; null if there is none.
  [[nodiscard]] Session* first() const;
  [[nodiscard]] Session* first_of(const std::string& peer) const;

 private:
  using Line = std::map<Ticket, Session*>;  // borrowed

  Line all_;
  std::map<std::string, Line> of_peer_;
  Ticket next_{0};
};

}  // namespace floeplan::http

#include "server/http/waiting_line.hpp"

namespace floeplan::http {

WaitingLine::Ticket WaitingLine::enter(Session& session, const std::string& peer) {
  const Ticket ticket = next_++;
  all_.emplace_hint(all_.end(), ticket, &session);
  Line& own = of_peer_[peer];
  own.emplace_hint(own.end(), ticket, &session);
  return ticket;
}

void WaitingLine::leave(Ticket ticket, const std::string& peer) {
  all_.erase(ticket);
  const auto own = of_peer_.find(peer);
  own->second.erase(ticket);
  if (own->second.empty()) of_peer_.erase(own);
}

Session* WaitingLine::first() const { return all_.empty() ? nullptr : all_.begin()->second; }

Session* WaitingLine::first_of(const std::string& peer) const {
  const auto own = of_peer_.find(peer);
  return own == of_peer_.end() ? nullptr : own->second.begin()->second;
}

}  // namespace floeplan::http

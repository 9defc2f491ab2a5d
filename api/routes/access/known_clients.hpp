#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <unordered_map>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// Tells the clients apart that share a server, before anything is looked up: by the name of the token whose credential was
/// let in before, so that logins of one token are one client; otherwise by their address, so that credentials that somebody
/// makes up are one client, too. Lets nobody in: a name here only says whose turn it is.
/// Memory   bounded: of the credentials only hashes, and of so many that all are forgotten at once when there are more
/// Threads  any number at once
class KnownClients {
 public:
  static constexpr std::size_t most_credentials = 10'000;

  explicit KnownClients(bool behind_proxy) : behind_proxy_{behind_proxy} {}

  [[nodiscard]] std::string client_of(const Request& request) const;
  /// Notes who was let in with what the request shows; `caller` is empty when nobody was.
  void learn(const Request& request, const std::string& caller);

 private:
  bool behind_proxy_;
  mutable std::mutex mutex_;
  std::unordered_map<std::size_t, std::string> names_;  // by hash of the credential
};

}  // namespace floeplan::routes

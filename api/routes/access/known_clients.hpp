#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <unordered_map>

#include "api/routes/request/message.hpp"

namespace floeplan::routes {

/// Identifies the client of a request before any database access, so that clients can take turns. A credential that was
/// accepted before counts as its token, so all logins of a token are one client. Any other credential counts as its network
/// address, so that invented credentials do not make more clients. This grants no access.
/// Memory   bounded: only hashes of credentials are stored; when there are too many, all are dropped
/// Threads  any number at once
class KnownClients {
 public:
  static constexpr std::size_t most_credentials = 10'000;

  explicit KnownClients(bool behind_proxy) : behind_proxy_{behind_proxy} {}

  [[nodiscard]] std::string client_of(const Request& request) const;
  /// Records the caller for the credential in the request; `caller` is empty if access was refused.
  void learn(const Request& request, const std::string& caller);

 private:
  bool behind_proxy_;
  mutable std::mutex mutex_;
  std::unordered_map<std::size_t, std::string> names_;  // by hash of the credential
};

}  // namespace floeplan::routes

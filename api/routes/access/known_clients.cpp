#include "api/routes/access/known_clients.hpp"

#include <functional>
#include <optional>

#include "api/routes/access/client_address.hpp"
#include "api/routes/access/shown_credential.hpp"

namespace floeplan::routes {
namespace {

/// Hash of the credential in the headers; empty without one. A login has no such header: its token is in the body.
std::optional<std::size_t> hash_of_credential(const Request& request) {
  const bool logs_in = request.method == "POST" && request.path == "/session";
  const auto shown = logs_in ? std::nullopt : shown_credential(request);
  if (!shown) return std::nullopt;
  return std::hash<std::string>{}(shown->text);
}

}  // namespace

std::string KnownClients::client_of(const Request& request) const {
  if (const auto hash = hash_of_credential(request)) {
    const std::lock_guard lock{mutex_};
    const auto found = names_.find(*hash);
    if (found != names_.end()) return "token " + found->second;
  }
  return "address " + (behind_proxy_ ? address_behind_proxy(request) : request.peer);
}

void KnownClients::learn(const Request& request, const std::string& caller) {
  if (caller.empty() || caller == local_caller.name) return;
  const auto hash = hash_of_credential(request);
  if (!hash) return;
  const std::lock_guard lock{mutex_};
  if (names_.size() >= most_credentials && !names_.contains(*hash)) names_.clear();
  names_[*hash] = caller;
}

}  // namespace floeplan::routes

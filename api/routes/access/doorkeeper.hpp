#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "api/routes/access/guess_guard.hpp"
#include "api/routes/request/context.hpp"
#include "api/routes/request/message.hpp"
#include "api/routes/request/router.hpp"
#include "engine/core/units.hpp"

namespace floeplan::routes {

/// Records logins and wrong credentials in the audit log: one entry for each address, action and period, with
/// a count. Many attempts thus do not displace other entries of the log. A count is written when it reaches a
/// power of two, so "at least 64 times" may be up to 127 times.
/// Memory   bounded: addresses after the first `most_addresses` of a period share one entry
/// Threads  any number at once
class LoginLedger {
 public:
  static constexpr core::Seconds period{600.0};
  static constexpr std::size_t most_addresses = 200;

  /// `caller`  name of the token used or guessed at; empty: no known token
  void note(const Context& context, const Request& request, const std::string& action,
            const std::string& caller);

 private:
  struct Tally {
    std::int64_t row{};  // row in the audit log
    std::uint64_t times{};
  };

  std::mutex mutex_;
  core::UtcTime began_{};  // start of the period
  std::map<std::string, Tally> tallies_;
};

/// How the doors of a server stand.
struct Doors {
  /// Requests without a token are allowed until the store has its first token. Set only if no other machine
  /// reaches the server.
  bool open_without_tokens{true};
  bool secure{false};  // clients use TLS; cookies are then only sent over TLS
  // all requests come through the operator's proxy, which states the client's address
  bool behind_proxy{false};
  // origins of other sites whose pages may send requests, as "https://map.example"
  std::vector<std::string> origins;
};

/// Access control in front of the resources. It identifies the caller and passes the request on, or refuses
/// with 401, 403 or 429; it answers cross-origin requests of browsers and records actions in the audit log.
///
/// A credential comes in the Authorization header (scripts) or in a cookie (browsers). With a cookie, a
/// request may change something only if it comes from a page of this server: the cookie is SameSite, and the
/// Origin header is checked as well. On a server without tokens, pages may only use host names of this
/// machine. Otherwise a page from outside could reach a server on loopback through its own domain name (DNS
/// rebinding).
/// Threads  any number at once
class Doorkeeper {
 public:
  Doorkeeper(Doors doors, Router router) : doors_{std::move(doors)}, router_{std::move(router)} {}

  [[nodiscard]] Response answer(const Context& context, Request request);
  /// The refusal of a file upload before its body is read; nullopt if the caller may send it.
  [[nodiscard]] std::optional<Response> refuse(const Context& context, Request request);

 private:
  [[nodiscard]] std::optional<Response> let_in(const Context& context, Request& request);
  [[nodiscard]] std::optional<Response> identify(const Context& context, Request& request);
  [[nodiscard]] bool is_allowed_origin(const std::string& origin) const;
  [[nodiscard]] bool is_own_page(const Request& request, const std::string& public_url) const;
  [[nodiscard]] std::optional<Response> refuse_foreign_page(const Context& context,
                                                            const Request& request) const;
  void allow_origin(const Request& request, Response& response) const;

  Doors doors_;
  Router router_;
  GuessGuard guard_;
  LoginLedger ledger_;
};

}  // namespace floeplan::routes

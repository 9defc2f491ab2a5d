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

/// Writes logins, and what was shown in vain, into the audit log: one entry for each address, action and period, which says
/// how often. However often somebody tries, the log of what else was done stays.
/// Counts are written when they reach a power of two: "at least 64 times" may have been 127.
/// Memory   bounded: addresses beyond the first `most_addresses` of a period share one entry
/// Threads  any number at once
class LoginLedger {
 public:
  static constexpr core::Seconds period{600.0};
  static constexpr std::size_t most_addresses = 200;

  /// `caller`  name of the token that it was done with or that was guessed at; empty: of none that is known
  void note(const Context& context, const Request& request, const std::string& action,
            const std::string& caller);

 private:
  struct Tally {
    std::int64_t row{};  // in the audit log
    std::uint64_t times{};
  };

  std::mutex mutex_;
  core::UtcTime began_{};  // of the period
  std::map<std::string, Tally> tallies_;
};

/// How the doors of a server stand.
struct Doors {
  /// Until the store gets its first token, and never again: only where this machine alone reaches the server.
  bool open_without_tokens{true};
  bool secure{false};                // clients come by TLS: cookies may travel by nothing else
  bool behind_proxy{false};          // every request comes from a proxy of ours that names its client
  std::vector<std::string> origins;  // of other sites whose pages may ask, as "https://map.example"
};

/// Stands before the resources: finds out who asks and lets in, or refuses with 401, 403 or 429; answers what browsers
/// ask across sites; writes down who did what.
///
/// A credential comes in the Authorization header (scripts) or as a cookie (browsers). A cookie alone changes nothing
/// unless the browser says that the page is ours: SameSite keeps it home already, the Origin header is looked at as
/// well.
/// Without tokens, names that are not this machine's are refused to pages, which could otherwise reach a server on
/// loopback through a name of their own.
/// Threads  any number at once
class Doorkeeper {
 public:
  Doorkeeper(Doors doors, Router router) : doors_{std::move(doors)}, router_{std::move(router)} {}

  [[nodiscard]] Response answer(const Context& context, Request request);
  /// The answer to a caller who may not send this file, before its body is there; nothing when he may.
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

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// What somebody may do; each role may do all that the one before it may.
enum class Role { viewer, pilot, admin };

[[nodiscard]] std::string role_name(Role role);
/// Nothing for a name that is none.
[[nodiscard]] std::optional<Role> role_of(const std::string& name);

/// A token as it is kept: without the secret that makes it one.
struct TokenRecord {
  std::string name;  // whose it is
  Role role{Role::viewer};
  std::string key;     // first part of the credential, not secret
  std::string digest;  // SHA-256 of the secret part, lower-case hexadecimal
  core::UtcTime created;
};

/// Somebody who logged in from a browser with a token; ends with the token at the latest.
struct LoginRecord {
  std::string key;
  std::string digest;
  core::UtcTime created;
  core::UtcTime expires;
};

/// Tokens and the logins that were opened with them. Every change is on disk when the call returns.
/// Threads  as the connection: one thread at a time
class TokenRepository {
 public:
  explicit TokenRepository(sql::Connection& db) : db_{db} {}

  /// False when there is one of this name already.
  [[nodiscard]] bool add(const TokenRecord& token);
  /// Ends its logins too. False when there is none of this name.
  bool remove(const std::string& name);
  /// By name.
  [[nodiscard]] std::vector<TokenRecord> list() const;
  [[nodiscard]] bool any() const;
  /// Whether there was ever a token, even if the last one has been revoked since.
  [[nodiscard]] bool ever_any() const;
  [[nodiscard]] std::optional<TokenRecord> find(const std::string& key) const;

  /// Logins whose time is over are forgotten on the way. False when the token is no longer there.
  [[nodiscard]] bool log_in(const std::string& token_key, const LoginRecord& login);
  /// The token that a login was opened with, under the login's key and digest; nothing once it has expired.
  [[nodiscard]] std::optional<TokenRecord> find_login(const std::string& key, core::UtcTime now) const;
  bool log_out(const std::string& key);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

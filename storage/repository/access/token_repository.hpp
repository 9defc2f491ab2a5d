#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Rights of a user; each role includes the rights of the roles before it.
enum class Role { viewer, pilot, admin };

[[nodiscard]] std::string role_name(Role role);
/// The role with this name; nullopt if there is none.
[[nodiscard]] std::optional<Role> role_of(const std::string& name);

/// A token as it is stored, without its secret.
struct TokenRecord {
  std::string name;  // name of the user
  Role role{Role::viewer};
  std::string key;     // first part of the credential, not secret
  std::string digest;  // SHA-256 of the secret part, lower-case hexadecimal
  core::UtcTime created;
};

/// A login from a browser with a token. It ends with the token at the latest.
struct LoginRecord {
  std::string key;
  std::string digest;
  core::UtcTime created;
  core::UtcTime expires;
};

/// Tokens, and logins with them. Every change is on disk when the call returns.
/// Threads  as the connection: one thread at a time
class TokenRepository {
 public:
  explicit TokenRepository(sql::Connection& db) : db_{db} {}

  /// Adds a token. False if the name is already used.
  [[nodiscard]] bool add(const TokenRecord& token);
  /// Removes a token and its logins. False if there is no token with this name.
  bool remove(const std::string& name);
  /// All tokens, sorted by name.
  [[nodiscard]] std::vector<TokenRecord> list() const;
  [[nodiscard]] bool any() const;
  /// Whether there was ever a token, even if the last one has been revoked since.
  [[nodiscard]] bool ever_any() const;
  [[nodiscard]] std::optional<TokenRecord> find(const std::string& key) const;

  /// Adds a login and removes expired ones. False if the token does not exist any more.
  [[nodiscard]] bool log_in(const std::string& token_key, const LoginRecord& login);
  /// The token of the login with this key, but with the login's key and digest; nullopt if it has expired.
  [[nodiscard]] std::optional<TokenRecord> find_login(const std::string& key, core::UtcTime now) const;
  bool log_out(const std::string& key);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

#include "storage/repository/access/token_repository.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

constexpr std::array<std::pair<Role, const char*>, 3> role_names{
    {{Role::viewer, "viewer"}, {Role::pilot, "pilot"}, {Role::admin, "admin"}}};

/// The record of a row with the columns name, role, key, digest, created_s.
TokenRecord read_token(const sql::Row& row) {
  const auto role = role_of(row.text(1));
  if (!role)
    throw std::runtime_error{messages::store_text<"stored-word-unknown">("a token's role", row.text(1))};
  return {
      .name = row.text(0), .role = *role, .key = row.text(2), .digest = row.text(3), .created = row.time(4)};
}

}  // namespace

std::string role_name(Role role) {
  for (const auto& [candidate, name] : role_names)
    if (candidate == role) return name;
  throw std::logic_error{"Role without a name"};
}

std::optional<Role> role_of(const std::string& name) {
  for (const auto& [role, candidate] : role_names)
    if (name == candidate) return role;
  return std::nullopt;
}

bool TokenRepository::add(const TokenRecord& token) {
  sql::Statement insert{db_,
                        "INSERT INTO token (name, role, key, digest, created_s) VALUES (?1, ?2, ?3, ?4, "
                        "?5) ON CONFLICT (name) DO NOTHING"};
  insert.bind_all(token.name, role_name(token.role), token.key, token.digest, token.created);
  return insert.run() > 0;
}

bool TokenRepository::remove(const std::string& name) {
  sql::Statement remove{db_, "DELETE FROM token WHERE name = ?1"};
  remove.bind(1, name);
  return remove.run() > 0;
}

std::vector<TokenRecord> TokenRepository::list() const {
  sql::Statement query{db_, "SELECT name, role, key, digest, created_s FROM token ORDER BY name"};
  std::vector<TokenRecord> tokens;
  while (query.step()) tokens.push_back(read_token(query));
  return tokens;
}

bool TokenRepository::any() const {
  sql::Statement query{db_, "SELECT 1 FROM token LIMIT 1"};
  return query.step();
}

bool TokenRepository::ever_any() const {
  sql::Statement query{db_, "SELECT 1 FROM first_token"};
  return query.step();
}

std::optional<TokenRecord> TokenRepository::find(const std::string& key) const {
  sql::Statement query{db_, "SELECT name, role, key, digest, created_s FROM token WHERE key = ?1"};
  query.bind(1, key);
  if (!query.step()) return std::nullopt;
  return read_token(query);
}

bool TokenRepository::log_in(const std::string& token_key, const LoginRecord& login) {
  sql::Transaction transaction{db_};
  sql::Statement forget{db_, "DELETE FROM login WHERE expires_s <= ?1"};
  forget.bind(1, login.created);
  forget.run();
  sql::Statement insert{db_,
                        "INSERT INTO login (token_row, key, digest, created_s, expires_s) SELECT row, ?2, "
                        "?3, ?4, ?5 FROM token WHERE key = ?1"};
  insert.bind_all(token_key, login.key, login.digest, login.created, login.expires);
  const bool opened = insert.run() > 0;
  transaction.commit();
  return opened;
}

std::optional<TokenRecord> TokenRepository::find_login(const std::string& key, core::UtcTime now) const {
  sql::Statement query{db_,
                       "SELECT token.name, token.role, login.key, login.digest, token.created_s FROM "
                       "login JOIN token ON token.row = login.token_row WHERE login.key = ?1 AND "
                       "login.expires_s > ?2"};
  query.bind_all(key, now);
  if (!query.step()) return std::nullopt;
  return read_token(query);
}

bool TokenRepository::log_out(const std::string& key) {
  sql::Statement remove{db_, "DELETE FROM login WHERE key = ?1"};
  remove.bind(1, key);
  return remove.run() > 0;
}

}  // namespace floeplan::repository

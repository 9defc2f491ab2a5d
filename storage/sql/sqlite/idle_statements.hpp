#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace floeplan::sql::sqlite {

/// Cache of one connection's statements that are not in use. Parsing and planning a statement takes several
/// times as long as running it, and a server runs the same statements all day. Keeps the most recently used
/// ones, up to a limit.
/// Threads  as the connection: one thread at a time
class IdleStatements {
 public:
  IdleStatements();
  ~IdleStatements();

  /// A cached statement with this text, without bound values, or a new one.
  /// Errors   SQLite::Exception when the database refuses
  [[nodiscard]] std::unique_ptr<SQLite::Statement> take(SQLite::Database& database, const std::string& sql);
  /// Ends the statement's run, which releases all locks, and puts it into the cache.
  void give_back(std::unique_ptr<SQLite::Statement> statement) noexcept;

 private:
  std::vector<std::unique_ptr<SQLite::Statement>> idle_;  // most recently used last
};

}  // namespace floeplan::sql::sqlite

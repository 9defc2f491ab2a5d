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

/// The statements of one connection that are not in use: to parse and plan one anew takes several times as long as to
/// run it, and a server runs the same few all day. Holds the ones that were used last, up to a bound.
/// Threads  as the connection: one thread at a time
class IdleStatements {
 public:
  IdleStatements();
  ~IdleStatements();

  /// One that is free, without values, or a new one.
  /// Errors   SQLite::Exception when the database refuses
  [[nodiscard]] std::unique_ptr<SQLite::Statement> take(SQLite::Database& database, const std::string& sql);
  /// Ends its run, which lets go of all locks, and keeps it for the next user.
  void give_back(std::unique_ptr<SQLite::Statement> statement) noexcept;

 private:
  std::vector<std::unique_ptr<SQLite::Statement>> idle_;  // the one used last at the end
};

}  // namespace floeplan::sql::sqlite

#include "storage/sql/sqlite/idle_statements.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <sqlite3.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace floeplan::sql::sqlite {
namespace {

// Number of cached statements. Chosen: searching them is cheap compared with parsing a statement.
constexpr std::size_t most_idle = 64;

}  // namespace

IdleStatements::IdleStatements() { idle_.reserve(most_idle + 1); }
IdleStatements::~IdleStatements() = default;

std::unique_ptr<SQLite::Statement> IdleStatements::take(SQLite::Database& database, const std::string& sql) {
  const auto found = std::find_if(idle_.rbegin(), idle_.rend(),
                                  [&](const auto& statement) { return statement->getQuery() == sql; });
  if (found == idle_.rend()) return std::make_unique<SQLite::Statement>(database, sql);
  auto statement = std::move(*found);
  idle_.erase(std::next(found).base());
  return statement;
}

void IdleStatements::give_back(std::unique_ptr<SQLite::Statement> statement) noexcept {
  try {
    if (statement->tryReset() != SQLITE_OK) return;  // a failed statement is not kept
    statement->clearBindings();
  } catch (const std::exception&) {
    return;
  }
  idle_.push_back(std::move(statement));
  if (idle_.size() > most_idle) idle_.erase(idle_.begin());
}

}  // namespace floeplan::sql::sqlite

#include "storage/sql/sqlite/sqlite_statement.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>

#include <utility>

#include "storage/sql/sqlite/idle_statements.hpp"
#include "storage/sql/sqlite/library_failure.hpp"

namespace floeplan::sql::sqlite {

SqliteStatement::SqliteStatement(SQLite::Database& database, IdleStatements& idle, const std::string& sql)
    : database_{database},
      idle_{idle},
      statement_{translated(database_, [&] { return idle_.take(database_, sql); })} {}

SqliteStatement::~SqliteStatement() { idle_.give_back(std::move(statement_)); }

void SqliteStatement::bind(int parameter, const std::string& value) {
  translated(database_, [&] { statement_->bind(parameter, value); });
}

void SqliteStatement::bind(int parameter, std::int64_t value) {
  translated(database_, [&] { statement_->bind(parameter, value); });
}

void SqliteStatement::bind(int parameter, double value) {
  translated(database_, [&] { statement_->bind(parameter, value); });
}

void SqliteStatement::bind(int parameter, std::span<const std::byte> value) {
  translated(database_, [&] { statement_->bind(parameter, value.data(), static_cast<int>(value.size())); });
}

void SqliteStatement::bind_null(int parameter, ColumnType) {
  translated(database_, [&] { statement_->bind(parameter); });
}

bool SqliteStatement::step() {
  return translated(database_, [&] { return statement_->executeStep(); });
}

int SqliteStatement::run() {
  return translated(database_, [&] {
    while (statement_->executeStep()) continue;
    const int changed = database_.getChanges();
    statement_->reset();
    return changed;
  });
}

void SqliteStatement::reset() {
  statement_->tryReset();  // returns the error of the last run again, which step() has already reported
}

bool SqliteStatement::is_null(int column) const {
  return translated(database_, [&] { return statement_->isColumnNull(column); });
}

std::string SqliteStatement::text(int column) const {
  return translated(database_, [&] { return statement_->getColumn(column).getString(); });
}

std::int64_t SqliteStatement::integer(int column) const {
  return translated(database_, [&] { return statement_->getColumn(column).getInt64(); });
}

double SqliteStatement::real(int column) const {
  return translated(database_, [&] { return statement_->getColumn(column).getDouble(); });
}

std::span<const std::byte> SqliteStatement::blob(int column) const {
  return translated(database_, [&] {
    const SQLite::Column value = statement_->getColumn(column);
    const auto* const bytes = static_cast<const std::byte*>(value.getBlob());
    return std::span{bytes, static_cast<std::size_t>(value.getBytes())};
  });
}

}  // namespace floeplan::sql::sqlite

#include "storage/sqlite/statement.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "storage/sqlite/failure.hpp"
#include "storage/sqlite/prepared_statements.hpp"

namespace floeplan::sqlite {
namespace {

/// Whatever the library throws inside `work` leaves as a Failure.
template <class Work>
auto translated(const SQLite::Database& database, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, database.getFilename());
  }
}

}  // namespace

void execute(Connection& db, const std::string& script) {
  translated(db.handle(), [&] { db.handle().exec(script); });
}

Statement::Statement(Connection& db, const std::string& sql)
    : database_{db.handle()},
      statements_{db.statements()},
      statement_{translated(database_, [&] { return statements_.take(database_, sql); })} {}

Statement::Statement(Statement&&) noexcept = default;

Statement::~Statement() {
  if (statement_) statements_.give_back(std::move(statement_));
}

void Statement::bind(int parameter, const std::string& value) {
  translated(database_, [&] { statement_->bind(parameter, value); });
}

void Statement::bind(int parameter, std::int64_t value) {
  translated(database_, [&] { statement_->bind(parameter, value); });
}

void Statement::bind(int parameter, double value) {
  if (std::isnan(value)) throw std::invalid_argument{"not a number cannot be stored"};
  translated(database_, [&] { statement_->bind(parameter, value); });
}

void Statement::bind(int parameter, std::span<const std::byte> value) {
  translated(database_, [&] { statement_->bind(parameter, value.data(), static_cast<int>(value.size())); });
}

void Statement::bind_null(int parameter) {
  translated(database_, [&] { statement_->bind(parameter); });
}

bool Statement::step() {
  return translated(database_, [&] { return statement_->executeStep(); });
}

int Statement::run() {
  return translated(database_, [&] {
    while (statement_->executeStep()) continue;
    const int changed = database_.getChanges();
    statement_->reset();
    return changed;
  });
}

bool Statement::is_null(int column) const {
  return translated(database_, [&] { return statement_->isColumnNull(column); });
}

std::string Statement::text(int column) const {
  return translated(database_, [&] { return statement_->getColumn(column).getString(); });
}

std::int64_t Statement::integer(int column) const {
  return translated(database_, [&] { return statement_->getColumn(column).getInt64(); });
}

double Statement::real(int column) const {
  return translated(database_, [&] { return statement_->getColumn(column).getDouble(); });
}

std::span<const std::byte> Statement::blob(int column) const {
  return translated(database_, [&] {
    const SQLite::Column value = statement_->getColumn(column);
    const auto* const bytes = static_cast<const std::byte*>(value.getBlob());
    return std::span{bytes, static_cast<std::size_t>(value.getBytes())};
  });
}

std::optional<std::string> Statement::optional_text(int column) const {
  return is_null(column) ? std::nullopt : std::optional{text(column)};
}

std::optional<double> Statement::optional_real(int column) const {
  return is_null(column) ? std::nullopt : std::optional{real(column)};
}

std::optional<core::UtcTime> Statement::optional_time(int column) const {
  return is_null(column) ? std::nullopt : std::optional{time(column)};
}

void Statement::reset() {
  statement_->tryReset();  // says once more how the last run ended, which its step has told already
}

}  // namespace floeplan::sqlite

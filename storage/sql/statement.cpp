#include "storage/sql/statement.hpp"

#include <cmath>
#include <stdexcept>

#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql {

void execute(Connection& db, const std::string& script) { db.driver().run_script(script); }

std::int64_t inserted_number(Statement& insert) {
  if (!insert.step()) throw Failure{"a statement that inserts a row inserted none"};
  const std::int64_t number = insert.integer(0);
  while (insert.step()) continue;  // a transaction with a statement that has not ended is not committed
  insert.reset();
  return number;
}

void Statement::bind(int parameter, double value) {
  if (std::isnan(value)) throw std::invalid_argument{"not a number cannot be stored"};
  prepared_->bind(parameter, value);
}

std::optional<std::string> Row::optional_text(int column) const {
  return is_null(column) ? std::nullopt : std::optional{text(column)};
}

std::optional<double> Row::optional_real(int column) const {
  return is_null(column) ? std::nullopt : std::optional{real(column)};
}

std::optional<core::UtcTime> Row::optional_time(int column) const {
  return is_null(column) ? std::nullopt : std::optional{time(column)};
}

}  // namespace floeplan::sql

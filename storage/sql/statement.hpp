#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "engine/core/units.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::sql {

class Statement;

/// Runs an INSERT to its end that returns one whole number, such as the number of the new row.
/// Returns  that number
/// Errors   Failure when it inserts nothing
[[nodiscard]] std::int64_t inserted_number(Statement& insert);

/// Runs a script of several statements that take no values and give no rows.
void execute(Connection& db, const std::string& script);

/// The current row of a statement. Columns count from 0.
/// Errors   Failure when there is no such column, or no current row
class Row {
 public:
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  [[nodiscard]] bool is_null(int column) const { return prepared_->is_null(column); }
  [[nodiscard]] std::string text(int column) const { return prepared_->text(column); }
  [[nodiscard]] std::int64_t integer(int column) const { return prepared_->integer(column); }
  [[nodiscard]] double real(int column) const { return prepared_->real(column); }
  [[nodiscard]] core::UtcTime time(int column) const { return core::from_unix_seconds(real(column)); }
  /// The view is valid until the next step.
  [[nodiscard]] std::span<const std::byte> blob(int column) const { return prepared_->blob(column); }
  [[nodiscard]] std::optional<std::string> optional_text(int column) const;
  [[nodiscard]] std::optional<double> optional_real(int column) const;
  [[nodiscard]] std::optional<core::UtcTime> optional_time(int column) const;

 protected:
  explicit Row(std::unique_ptr<PreparedStatement> prepared) : prepared_{std::move(prepared)} {}
  Row(Row&&) = default;
  ~Row() = default;

  std::unique_ptr<PreparedStatement> prepared_;
};

/// The column type for values of a C++ type.
template <class T>
constexpr ColumnType column_type_of() {
  if constexpr (std::is_integral_v<T>) return ColumnType::integer;
  if constexpr (std::is_floating_point_v<T> || std::is_same_v<T, core::UtcTime>) return ColumnType::real;
  if constexpr (std::is_convertible_v<T, std::span<const std::byte>>) return ColumnType::blob;
  return ColumnType::text;
}

/// One prepared statement, and the row at which it stands. Parameters count from 1.
/// Edges    an empty optional is NULL; text and blobs are copied when bound
/// Threads  as the connection: one thread at a time
/// Errors   Failure when the database refuses; std::invalid_argument for a NaN, which SQL would store as NULL
class Statement : public Row {
 public:
  Statement(Connection& db, const std::string& sql) : Row{db.driver().prepare(sql)} {}

  void bind(int parameter, const std::string& value) { prepared_->bind(parameter, value); }
  void bind(int parameter, std::int64_t value) { prepared_->bind(parameter, value); }
  void bind(int parameter, int value) { bind(parameter, std::int64_t{value}); }
  void bind(int parameter, double value);
  void bind(int parameter, core::UtcTime value) { bind(parameter, core::unix_seconds(value)); }
  void bind(int parameter, std::span<const std::byte> value) { prepared_->bind(parameter, value); }
  void bind_null(int parameter, ColumnType type) { prepared_->bind_null(parameter, type); }

  template <class T>
  void bind(int parameter, const std::optional<T>& value) {
    if (value) {
      bind(parameter, *value);
    } else {
      bind_null(parameter, column_type_of<T>());
    }
  }

  /// Binds the values to the parameters 1, 2, 3, ...
  template <class... Values>
  void bind_all(const Values&... values) {
    int parameter = 0;
    (bind(++parameter, values), ...);
  }

  /// Moves to the next row. False: there is none.
  [[nodiscard]] bool step() { return prepared_->step(); }
  /// Runs the statement to its end and resets it. Returns the number of changed rows.
  int run() { return prepared_->run(); }
  /// Resets the statement, so that it can be bound and run again.
  void reset() { prepared_->reset(); }
};

}  // namespace floeplan::sql

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/sqlite/connection.hpp"

namespace SQLite {
class Statement;
}

namespace floeplan::sqlite {

/// Runs a script of several statements that take no values and give no rows.
void execute(Connection& db, const std::string& script);

/// One prepared statement, lent by the connection's store of them. Parameters count from 1, columns from 0, as in SQL
/// itself.
/// Edges    an empty optional is NULL; text and blobs are copied when bound
/// Threads  as the connection: one thread at a time
/// Errors   Failure when the database refuses; std::invalid_argument for a NaN, which SQL would take for NULL
class Statement {
 public:
  Statement(Connection& db, const std::string& sql);
  Statement(Statement&&) noexcept;
  ~Statement();

  void bind(int parameter, const std::string& value);
  void bind(int parameter, std::int64_t value);
  void bind(int parameter, int value) { bind(parameter, std::int64_t{value}); }
  void bind(int parameter, double value);
  void bind(int parameter, core::UtcTime value) { bind(parameter, core::unix_seconds(value)); }
  void bind(int parameter, std::span<const std::byte> value);
  void bind_null(int parameter);

  template <class T>
  void bind(int parameter, const std::optional<T>& value) {
    if (value) {
      bind(parameter, *value);
    } else {
      bind_null(parameter);
    }
  }

  /// Binds the values to the parameters 1, 2, 3, ...
  template <class... Values>
  void bind_all(const Values&... values) {
    int parameter = 0;
    (bind(++parameter, values), ...);
  }

  /// Moves on to the next row. False: there is none.
  [[nodiscard]] bool step();
  /// Runs the statement to its end, ready to be bound and run again. Returns how many rows it changed.
  int run();

  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] core::UtcTime time(int column) const { return core::from_unix_seconds(real(column)); }
  /// Valid until the next step.
  [[nodiscard]] std::span<const std::byte> blob(int column) const;
  [[nodiscard]] std::optional<std::string> optional_text(int column) const;
  [[nodiscard]] std::optional<double> optional_real(int column) const;
  [[nodiscard]] std::optional<core::UtcTime> optional_time(int column) const;

  /// Ready to be bound and run again.
  void reset();

 private:
  SQLite::Database& database_;      // borrowed
  PreparedStatements& statements_;  // borrowed
  std::unique_ptr<SQLite::Statement> statement_;
};

}  // namespace floeplan::sqlite

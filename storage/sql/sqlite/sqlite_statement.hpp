#pragma once

#include <memory>
#include <string>

#include "storage/sql/driver/driver.hpp"

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace floeplan::sql::sqlite {

class IdleStatements;

/// A statement of SQLite, taken from the connection's cache of idle statements and returned to it.
class SqliteStatement : public PreparedStatement {
 public:
  SqliteStatement(SQLite::Database& database, IdleStatements& idle, const std::string& sql);
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;
  ~SqliteStatement() override;

  void bind(int parameter, const std::string& value) override;
  void bind(int parameter, std::int64_t value) override;
  void bind(int parameter, double value) override;
  void bind(int parameter, std::span<const std::byte> value) override;
  void bind_null(int parameter, ColumnType type) override;

  [[nodiscard]] bool step() override;
  int run() override;
  void reset() override;

  [[nodiscard]] bool is_null(int column) const override;
  [[nodiscard]] std::string text(int column) const override;
  [[nodiscard]] std::int64_t integer(int column) const override;
  [[nodiscard]] double real(int column) const override;
  [[nodiscard]] std::span<const std::byte> blob(int column) const override;

 private:
  SQLite::Database& database_;  // borrowed
  IdleStatements& idle_;        // borrowed
  std::unique_ptr<SQLite::Statement> statement_;
};

}  // namespace floeplan::sql::sqlite

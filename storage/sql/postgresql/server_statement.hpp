#pragma once

#include "storage/sql/driver/driver.hpp"
#include "storage/sql/postgresql/parameters.hpp"
#include "storage/sql/postgresql/server_session.hpp"

namespace floeplan::sql::postgresql {

/// A statement of a session. The first step runs the statement to its end and takes all of its rows, so that
/// other statements of the session may run while these rows are read.
/// Errors   faults that the server finds in the text are reported by the first step, which knows the types of
///          the values
class ServerStatement final : public PreparedStatement {
 public:
  /// `session` is borrowed.
  ServerStatement(ServerSession& session, const std::string& sql);

  void bind(int parameter, const std::string& value) override { put(parameter, wire_value(value)); }
  void bind(int parameter, std::int64_t value) override { put(parameter, wire_value(value)); }
  void bind(int parameter, double value) override { put(parameter, wire_value(value)); }
  void bind(int parameter, std::span<const std::byte> value) override { put(parameter, wire_value(value)); }
  void bind_null(int parameter, ColumnType type) override { put(parameter, wire_null(type)); }

  [[nodiscard]] bool step() override;
  int run() override;
  void reset() override;

  [[nodiscard]] bool is_null(int column) const override;
  [[nodiscard]] std::string text(int column) const override;
  [[nodiscard]] std::int64_t integer(int column) const override;
  [[nodiscard]] double real(int column) const override;
  [[nodiscard]] std::span<const std::byte> blob(int column) const override;

 private:
  void put(int parameter, WireValue value);
  void check(int column) const;

  ServerSession& session_;
  ServerText text_;
  std::vector<WireValue> values_;  // of the server's parameters
  Result result_;                  // null: not run yet
  int row_{-1};
};

}  // namespace floeplan::sql::postgresql

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "storage/sql/connection.hpp"

/// What tables a database has. `schema` is "main", or the name of an attached database.
namespace floeplan::sql {

struct Column {
  std::string name;
  ColumnType type{};
};

/// The columns of a table of "main" that are stored, in their order; none of a table that is not there.
[[nodiscard]] std::vector<Column> columns_of(Connection& db, const std::string& table);

/// Whether "main" has it.
[[nodiscard]] bool has_table(Connection& db, const std::string& name);

/// Names of the tables that hold rows of ours: not those of the engine, nor indices of boxes, nor the tables in which such an
/// index keeps itself. By name. Works where an index of boxes is damaged.
/// Parameters  with     only tables that have this column; empty: all
///             without  but for those that have one of these columns
[[nodiscard]] std::vector<std::string> tables_of(Connection& db, const std::string& schema,
                                                 std::string_view with,
                                                 const std::vector<std::string>& without = {});

/// The highest number that a row of a table of "main", whose column `row` numbers them, has or ever had.
[[nodiscard]] std::int64_t highest_row(Connection& db, const std::string& table);

/// Whether `schema` has nothing (tables, indices, triggers, views) that "main" has not word for word.
[[nodiscard]] bool has_only_tables_of_main(Connection& db, const std::string& schema);

}  // namespace floeplan::sql

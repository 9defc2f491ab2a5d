#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "storage/sql/connection.hpp"

/// Functions about the tables of a database. `schema` is "main", or the name of an attached database.
namespace floeplan::sql {

struct Column {
  std::string name;
  ColumnType type{};
};

/// The stored columns of a table of "main", in their order; none if the table does not exist.
[[nodiscard]] std::vector<Column> columns_of(Connection& db, const std::string& table);

/// Whether "main" has a table with this name.
[[nodiscard]] bool has_table(Connection& db, const std::string& name);

/// Names of the tables with this program's own rows, sorted. Tables of SQLite, R*Trees and the tables in
/// which an R*Tree stores its data are not included. Works even if an R*Tree is damaged.
/// Parameters  with     only tables with this column; empty: all without  no tables with any of these columns
[[nodiscard]] std::vector<std::string> tables_of(Connection& db, const std::string& schema,
                                                 std::string_view with,
                                                 const std::vector<std::string>& without = {});

/// The highest number that a row of a table of "main" has or ever had. The table's column `row` has the
/// numbers.
[[nodiscard]] std::int64_t highest_row(Connection& db, const std::string& table);

/// The next row of a table gets a number above this one. Does nothing where the database gives no numbers.
void continue_rows(Connection& db, const std::string& table, std::int64_t highest);

/// Whether everything in `schema` (tables, indices, triggers, views) also exists in "main" with the same
/// definition.
[[nodiscard]] bool has_only_tables_of_main(Connection& db, const std::string& schema);

}  // namespace floeplan::sql

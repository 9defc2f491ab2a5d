#pragma once

#include <string>
#include <vector>

#include "storage/sqlite/connection.hpp"

namespace floeplan::repository {

enum class ColumnType { integer, real, text, blob };

struct Column {
  std::string name;
  ColumnType type{};
};

/// The columns of a table that are stored, in their order; none of a table that is not there.
[[nodiscard]] std::vector<Column> columns_of(sqlite::Connection& db, const std::string& table);

[[nodiscard]] bool has_table(sqlite::Connection& db, const std::string& name);

/// Every table whose rows belong to datasets, by name. They are found by their column: a new kind of data takes part
/// without a word here.
[[nodiscard]] std::vector<std::string> tables_of_data(sqlite::Connection& db);

/// Of the R*Tree with the boxes of a table's rows; there need be none.
[[nodiscard]] std::string boxes_of(const std::string& table);

}  // namespace floeplan::repository

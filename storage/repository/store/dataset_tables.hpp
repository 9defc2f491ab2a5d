#pragma once

#include <string>
#include <vector>

#include "storage/sql/tables.hpp"

namespace floeplan::repository {

/// Every table whose rows belong to datasets, by name. They are found by their column: a new kind of data takes part
/// without a word here.
[[nodiscard]] std::vector<std::string> tables_of_data(sql::Connection& db);

/// Name of the R*Tree with the boxes of a table's rows, whether or not the table has one.
[[nodiscard]] std::string boxes_of(const std::string& table);

}  // namespace floeplan::repository

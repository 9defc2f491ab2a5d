#pragma once

#include <string>
#include <vector>

#include "storage/sql/tables.hpp"

namespace floeplan::repository {

/// All tables whose rows belong to datasets, sorted by name. They are found by their column `dataset_row`, so
/// tables of a new kind of data are included without a change here.
[[nodiscard]] std::vector<std::string> tables_of_data(sql::Connection& db);

/// Name of the R*Tree with the boxes of a table's rows, whether or not the table has one.
[[nodiscard]] std::string boxes_of(const std::string& table);

}  // namespace floeplan::repository

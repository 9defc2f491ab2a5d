#include "storage/repository/store/dataset_tables.hpp"

namespace floeplan::repository {

std::vector<std::string> tables_of_data(sql::Connection& db) {
  return sql::tables_of(db, "main", "dataset_row");
}

std::string boxes_of(const std::string& table) { return table + "_box"; }

}  // namespace floeplan::repository

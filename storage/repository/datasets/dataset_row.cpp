#include "storage/repository/datasets/dataset_row.hpp"

#include <stdexcept>

#include "storage/sql/statement.hpp"

namespace floeplan::repository {

std::optional<std::int64_t> find_dataset_row(sql::Connection& db, const DatasetId& id) {
  sql::Statement query{db, "SELECT row FROM dataset WHERE id = ?1"};
  query.bind(1, id.value);
  if (!query.step()) return std::nullopt;
  return query.integer(0);
}

std::int64_t dataset_row(sql::Connection& db, const DatasetId& id) {
  const auto row = find_dataset_row(db, id);
  if (!row) throw std::invalid_argument{"no dataset " + id.value + ": insert it before its data"};
  return *row;
}

}  // namespace floeplan::repository

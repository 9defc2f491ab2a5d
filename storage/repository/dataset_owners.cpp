#include "storage/repository/dataset_owners.hpp"

#include "storage/sqlite/statement.hpp"

namespace floeplan::repository {

void DatasetOwners::note(const DatasetId& id, const std::string& owner) {
  sqlite::Statement update{db_, "UPDATE dataset SET owner = ?2 WHERE id = ?1 AND owner IS NULL"};
  update.bind_all(id.value, owner);
  update.run();
}

std::uint64_t DatasetOwners::bytes_of(const std::string& owner) const {
  sqlite::Statement query{db_, "SELECT coalesce(sum(file_size_bytes), 0) FROM dataset WHERE owner = ?1"};
  query.bind(1, owner);
  return query.step() ? static_cast<std::uint64_t>(query.integer(0)) : 0;
}

}  // namespace floeplan::repository

#include "storage/repository/access/owners.hpp"

#include "storage/sql/statement.hpp"

namespace floeplan::repository {
namespace {

/// The sums use only columns in an index on the owner, so no document is read.
constexpr const char* stored_bytes =
    "SELECT CAST((SELECT coalesce(sum(file_size_bytes), 0) FROM dataset WHERE owner = ?1) + "
    "(SELECT coalesce(sum(stored_bytes), 0) FROM plan WHERE owner = ?1) + "
    "(SELECT coalesce(sum(stored_bytes), 0) FROM simulation WHERE owner = ?1) AS BIGINT)";

}  // namespace

void Owners::note_dataset(const std::string& id, const std::string& owner) {
  sql::Statement update{db_, "UPDATE dataset SET owner = ?2 WHERE id = ?1 AND owner IS NULL"};
  update.bind_all(id, owner);
  update.run();
}

void Owners::note_made(const ThingTable& table, const std::string& id, core::UtcTime made,
                       const std::string& owner) {
  sql::Statement update{db_, "UPDATE " + std::string{table.table} +
                                 " SET owner = ?3 WHERE id = ?1 AND created_s = ?2 AND owner IS NULL"};
  update.bind_all(id, made, owner);
  update.run();
}

std::uint64_t Owners::bytes_of(const std::string& owner) const {
  sql::Statement query{db_, stored_bytes};
  query.bind(1, owner);
  return query.step() ? static_cast<std::uint64_t>(query.integer(0)) : 0;
}

}  // namespace floeplan::repository

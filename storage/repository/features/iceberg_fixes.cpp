#include "storage/repository/features/iceberg_fixes.hpp"

#include "storage/sql/statement.hpp"

namespace floeplan::repository {

std::vector<ocean::IcebergFix> iceberg_fixes(sql::Connection& db, const DatasetId& dataset,
                                             const std::string& berg_id, std::optional<core::UtcTime> from,
                                             std::optional<core::UtcTime> before) {
  std::string sql =
      "SELECT lon_deg, lat_deg, observed_s FROM sighting AS own WHERE dataset_row = (SELECT row FROM dataset "
      "WHERE "
      "id = ?1) AND berg_id = ?2 AND row = (SELECT max(same.row) FROM sighting AS same WHERE "
      "same.dataset_row = "
      "own.dataset_row AND same.berg_id = own.berg_id AND same.observed_s = own.observed_s)";
  if (from) sql += " AND observed_s >= ?3";
  if (before) sql += " AND observed_s < ?4";
  sql::Statement query{db, sql + " ORDER BY observed_s"};
  query.bind_all(dataset.value, berg_id);
  if (from) query.bind(3, *from);
  if (before) query.bind(4, *before);
  std::vector<ocean::IcebergFix> fixes;
  while (query.step()) fixes.push_back({{query.real(0), query.real(1)}, query.time(2)});
  return fixes;
}

}  // namespace floeplan::repository

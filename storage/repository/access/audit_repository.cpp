#include "storage/repository/access/audit_repository.hpp"

#include <algorithm>

#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {

std::int64_t AuditRepository::add(const AuditEntry& entry) {
  sql::Transaction transaction{db_};
  sql::Statement insert{
      db_,
      "INSERT INTO audit (at_s, caller, peer, action, target, request_id) VALUES (?1, ?2, ?3, ?4, ?5, ?6) "
      "RETURNING row"};
  insert.bind_all(entry.at, entry.caller, entry.peer, entry.action, entry.target, entry.request_id);
  const std::int64_t row = sql::inserted_number(insert);
  sql::Statement forget{db_, "DELETE FROM audit WHERE row <= (SELECT max(row) FROM audit) - ?1"};
  forget.bind(1, most_entries);
  forget.run();
  transaction.commit();
  return row;
}

void AuditRepository::restate(std::int64_t row, const std::string& target) {
  sql::Statement change{db_, "UPDATE audit SET target = ?2 WHERE row = ?1"};
  change.bind_all(row, target);
  change.run();
}

std::vector<AuditEntry> AuditRepository::list(std::int64_t before, int limit) const {
  sql::Statement query{db_,
                       "SELECT row, at_s, caller, peer, action, target, request_id FROM audit WHERE ?1 = 0 "
                       "OR row < ?1 ORDER BY row DESC LIMIT ?2"};
  query.bind_all(before, std::max(limit, 0));
  std::vector<AuditEntry> entries;
  while (query.step()) {
    entries.push_back({.row = query.integer(0),
                       .at = query.time(1),
                       .caller = query.text(2),
                       .peer = query.text(3),
                       .action = query.text(4),
                       .target = query.text(5),
                       .request_id = query.text(6)});
  }
  return entries;
}

}  // namespace floeplan::repository

#include "storage/sql/shared/roles.hpp"

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

void admit_role(Connection& db, const std::string& role) {
  Statement query{
      db,
      "SELECT format('GRANT USAGE ON SCHEMA %1$I TO %2$I; GRANT SELECT, INSERT, UPDATE, DELETE ON ALL TABLES IN "
      "SCHEMA %1$I TO %2$I; GRANT USAGE, SELECT ON ALL SEQUENCES IN SCHEMA %1$I TO %2$I', current_schema(), ?1)"};
  query.bind(1, role);
  if (query.step()) execute(db, query.text(0));
}

}  // namespace floeplan::sql

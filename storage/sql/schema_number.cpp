#include "storage/sql/schema_number.hpp"

#include <string>

#include "storage/sql/sqlite/database_files.hpp"
#include "storage/sql/statement.hpp"

namespace floeplan::sql {

std::int64_t schema_number(Connection& db) {
  Statement query{db, "PRAGMA user_version"};
  return query.step() ? query.integer(0) : 0;
}

void set_schema_number(Connection& db, std::int64_t number) {
  execute(db, "PRAGMA application_id = " + std::to_string(sqlite::application_id));
  execute(db, "PRAGMA user_version = " + std::to_string(number));
}

}  // namespace floeplan::sql

#include "storage/sql/schema_number.hpp"

#include <algorithm>
#include <string>

#include "storage/sql/sqlite/database_files.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/tables.hpp"

namespace floeplan::sql {

std::int64_t schema_number(Connection& db) {
  if (db.engine() == Engine::server) {
    if (!has_table(db, "store_schema")) return 0;
    Statement query{db, "SELECT number FROM store_schema"};
    return query.step() ? query.integer(0) : 0;
  }
  Statement query{db, "PRAGMA user_version"};
  return query.step() ? query.integer(0) : 0;
}

std::int64_t schema_usable_from(Connection& db) {
  const auto states_it = [&] {
    return std::ranges::any_of(columns_of(db, "store_schema"),
                               [](const Column& column) { return column.name == "usable_from"; });
  };
  if (db.engine() != Engine::server || !states_it()) return schema_number(db);
  Statement query{db, "SELECT usable_from FROM store_schema"};
  return query.step() ? query.integer(0) : 0;
}

void set_schema_number(Connection& db, std::int64_t number, std::int64_t usable_from) {
  if (db.engine() == Engine::server) {
    execute(db,
            "CREATE TABLE IF NOT EXISTS store_schema (number bigint NOT NULL); "
            "ALTER TABLE store_schema ADD COLUMN IF NOT EXISTS usable_from bigint NOT NULL DEFAULT 0; "
            "DELETE FROM store_schema; INSERT INTO store_schema (number, usable_from) VALUES (" +
                std::to_string(number) + ", " + std::to_string(usable_from) + ")");
    return;
  }
  execute(db, "PRAGMA application_id = " + std::to_string(sqlite::application_id));
  execute(db, "PRAGMA user_version = " + std::to_string(number));
}

}  // namespace floeplan::sql

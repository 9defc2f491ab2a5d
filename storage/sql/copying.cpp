#include "storage/sql/copying.hpp"

#include <cstdint>
#include <vector>

#include "storage/sql/own_tables.hpp"
#include "storage/sql/salvage.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::sql {
namespace {

void run_scripts(Connection& db, const std::string& schema, const std::string& which) {
  std::vector<std::string> scripts;
  {
    Statement query{db, "SELECT sql FROM " + schema + ".sqlite_schema AS t WHERE sql IS NOT NULL AND " +
                            which + " ORDER BY rowid"};
    while (query.step()) scripts.push_back(query.text(0));
  }
  for (const std::string& script : scripts) execute(db, script);
}

std::int64_t number_in_header(Connection& db, const std::string& schema, const std::string& name) {
  Statement query{db, "PRAGMA " + schema + "." + name};
  return query.step() ? query.integer(0) : 0;
}

}  // namespace

Connection open_copy(const std::filesystem::path& folder) {
  auto db = Connection::open(folder);
  // Only now: the first page, which states that there are checksums, has been written.
  execute(db, "PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF; PRAGMA foreign_keys = OFF");
  return db;
}

/// Creating an R*Tree also creates the tables in which it stores its data.
void make_tables_as_in(Connection& db, const std::string& schema) {
  run_scripts(db, schema, own_tables);
  run_scripts(db, schema, "t.sql LIKE 'CREATE VIRTUAL TABLE%'");
}

void make_indices_as_in(Connection& db, const std::string& schema) {
  run_scripts(db, schema, "type IN ('index', 'trigger')");
}

void take_highest_rows_from(Connection& db, const std::string& schema) {
  const bool whole = meets_no_damage([&] {
    Transaction part{db};
    execute(db, "DELETE FROM main.sqlite_sequence; INSERT INTO main.sqlite_sequence SELECT * FROM " + schema +
                    ".sqlite_sequence");
    part.commit();
  });
  (void)whole;  // if not, the copied rows give the highest numbers
}

void take_schema_number_from(Connection& db, const std::string& schema) {
  for (const char* const name : {"application_id", "user_version"})
    execute(db,
            std::string{"PRAGMA main."} + name + " = " + std::to_string(number_in_header(db, schema, name)));
}

void finish_copy(Connection& db) { execute(db, "PRAGMA journal_mode = DELETE"); }

}  // namespace floeplan::sql

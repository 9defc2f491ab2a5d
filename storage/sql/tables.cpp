#include "storage/sql/tables.hpp"

#include <stdexcept>

#include "storage/sql/own_tables.hpp"
#include "storage/sql/statement.hpp"

namespace floeplan::sql {
namespace {

ColumnType type_of(const std::string& declared) {
  if (declared == "INTEGER" || declared == "INT" || declared == "bigint")  // INT: the key of an R*Tree
    return ColumnType::integer;
  if (declared == "REAL" || declared == "double precision") return ColumnType::real;
  if (declared == "TEXT" || declared == "text") return ColumnType::text;
  if (declared == "BLOB" || declared == "bytea") return ColumnType::blob;
  throw std::logic_error{"a column of the type " + declared};
}

/// Whether the database gives the rows of a table their numbers.
bool numbers_rows(Connection& db, const std::string& table) {
  Statement query{db, db.engine() == Engine::server
                          ? "SELECT 1 FROM information_schema.columns WHERE table_schema = current_schema() "
                            "AND table_name = ?1 AND column_name = 'row' AND is_identity = 'YES'"
                          : "SELECT 1 FROM main.sqlite_schema WHERE type = 'table' AND name = ?1 AND sql LIKE "
                            "'%AUTOINCREMENT%'"};
  query.bind(1, table);
  return query.step();
}

std::string has_column(const std::string& schema, std::string_view column) {
  return "EXISTS (SELECT 1 FROM pragma_table_info(t.name, '" + schema + "') AS c WHERE c.name = '" +
         std::string{column} + "')";
}

}  // namespace

std::vector<Column> columns_of(Connection& db, const std::string& table) {
  Statement query{
      db, db.engine() == Engine::server
              ? "SELECT column_name::text, data_type::text FROM information_schema.columns WHERE "
                "table_schema = current_schema() AND table_name = ?1 AND is_generated = 'NEVER' ORDER BY "
                "ordinal_position"
              : "SELECT name, type FROM pragma_table_info(?1) ORDER BY cid"};
  query.bind(1, table);
  std::vector<Column> columns;
  while (query.step()) columns.push_back({query.text(0), type_of(query.text(1))});
  return columns;
}

bool has_table(Connection& db, const std::string& name) {
  Statement query{db, db.engine() == Engine::server
                          ? "SELECT 1 FROM pg_tables WHERE schemaname = current_schema() AND tablename = ?1"
                          : "SELECT 1 FROM main.sqlite_schema WHERE type = 'table' AND name = ?1"};
  query.bind(1, name);
  return query.step();
}

/// The tables of a schema. PRAGMA table_list is not used: it reads from R*Trees and fails where one is damaged.
std::vector<std::string> tables_of(Connection& db, const std::string& schema, std::string_view with,
                                   const std::vector<std::string>& without) {
  std::string condition = own_tables;
  if (!with.empty()) condition += " AND " + has_column(schema, with);
  for (const std::string& column : without) condition += " AND NOT " + has_column(schema, column);
  Statement query{
      db, "SELECT t.name FROM " + schema + ".sqlite_schema AS t WHERE " + condition + " ORDER BY t.name"};
  std::vector<std::string> names;
  while (query.step()) names.push_back(query.text(0));
  return names;
}

std::int64_t highest_row(Connection& db, const std::string& table) {
  Statement query{
      db, db.engine() == Engine::server
              ? "SELECT greatest(coalesce((SELECT max(row) FROM " + table +
                    "), 0), coalesce(pg_sequence_last_value(pg_get_serial_sequence(?1, 'row')::regclass), 0))"
              : "SELECT max(coalesce((SELECT max(row) FROM main." + table +
                    "), 0), coalesce((SELECT seq FROM main.sqlite_sequence WHERE name = ?1), 0))"};
  query.bind(1, table);
  return query.step() ? query.integer(0) : 0;
}

void continue_rows(Connection& db, const std::string& table, std::int64_t highest) {
  if (highest == 0 || !numbers_rows(db, table)) return;
  if (db.engine() == Engine::server) {
    Statement query{db, "SELECT setval(pg_get_serial_sequence(?1, 'row')::regclass, ?2)"};
    query.bind_all(table, highest);
    (void)query.step();
    return;
  }
  Statement remove{db, "DELETE FROM main.sqlite_sequence WHERE name = ?1"};
  remove.bind(1, table);
  remove.run();
  Statement insert{db, "INSERT INTO main.sqlite_sequence (name, seq) VALUES (?1, ?2)"};
  insert.bind_all(table, highest);
  insert.run();
}

bool has_only_tables_of_main(Connection& db, const std::string& schema) {
  Statement differing{db, "SELECT name FROM " + schema +
                              ".sqlite_schema AS there WHERE NOT EXISTS (SELECT 1 FROM main.sqlite_schema AS "
                              "here WHERE here.name = there.name AND here.type = there.type AND here.sql IS "
                              "there.sql)"};
  return !differing.step();
}

}  // namespace floeplan::sql

#include "storage/repository/dataset_tables.hpp"

#include <stdexcept>

#include "storage/sqlite/statement.hpp"

namespace floeplan::repository {
namespace {

ColumnType type_of(const std::string& declared) {
  if (declared == "INTEGER" || declared == "INT") return ColumnType::integer;  // INT: the key of an R*Tree
  if (declared == "REAL") return ColumnType::real;
  if (declared == "TEXT") return ColumnType::text;
  if (declared == "BLOB") return ColumnType::blob;
  throw std::logic_error{"a column of the type " + declared};
}

}  // namespace

std::vector<Column> columns_of(sqlite::Connection& db, const std::string& table) {
  sqlite::Statement query{db, "SELECT name, type FROM pragma_table_info(?1) ORDER BY cid"};
  query.bind(1, table);
  std::vector<Column> columns;
  while (query.step()) columns.push_back({query.text(0), type_of(query.text(1))});
  return columns;
}

bool has_table(sqlite::Connection& db, const std::string& name) {
  sqlite::Statement query{db, "SELECT 1 FROM main.sqlite_schema WHERE type = 'table' AND name = ?1"};
  query.bind(1, name);
  return query.step();
}

std::vector<std::string> tables_of_data(sqlite::Connection& db) {
  sqlite::Statement query{db,
                          "SELECT t.name FROM main.sqlite_schema AS t JOIN pragma_table_info(t.name) AS c "
                          "WHERE t.type = 'table' AND c.name = 'dataset_row' ORDER BY t.name"};
  std::vector<std::string> tables;
  while (query.step()) tables.push_back(query.text(0));
  return tables;
}

std::string boxes_of(const std::string& table) { return table + "_box"; }

}  // namespace floeplan::repository

#include "storage/repository/dataset_transfer.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "storage/sqlite/attachment.hpp"
#include "storage/sqlite/statement.hpp"
#include "storage/sqlite/transaction.hpp"

namespace floeplan::repository {
namespace {

/// A table whose rows belong to datasets.
struct Table {
  std::string name;
  std::vector<std::string> columns;  // those that are stored
  std::int64_t row_offset{};         // from a row's number there to its number here
};

std::vector<std::string> columns_of(sqlite::Connection& db, const std::string& table) {
  sqlite::Statement query{db, "SELECT name FROM pragma_table_info(?1) ORDER BY cid"};
  query.bind(1, table);
  std::vector<std::string> columns;
  while (query.step()) columns.push_back(query.text(0));
  return columns;
}

bool has_table(sqlite::Connection& db, const std::string& name) {
  sqlite::Statement query{db, "SELECT 1 FROM main.sqlite_schema WHERE type = 'table' AND name = ?1"};
  query.bind(1, name);
  return query.step();
}

/// The highest number that a row of the table has or ever had; 0 of a table whose rows have no numbers.
std::int64_t highest_row(sqlite::Connection& db, const Table& table) {
  if (std::ranges::find(table.columns, "row") == table.columns.end()) return 0;
  sqlite::Statement query{db,
                          "SELECT max(coalesce((SELECT max(row) FROM main." + table.name +
                              "), 0), coalesce((SELECT seq FROM main.sqlite_sequence WHERE name = ?1), 0))"};
  query.bind(1, table.name);
  return query.step() ? query.integer(0) : 0;
}

Table table_of(sqlite::Connection& db, const std::string& name) {
  Table table{name, columns_of(db, name)};
  table.row_offset = highest_row(db, table);
  return table;
}

/// Every table with data of datasets, found by its column: a new kind of data is taken over without a word here.
std::vector<Table> tables_of_data(sqlite::Connection& db) {
  sqlite::Statement query{db,
                          "SELECT t.name FROM main.sqlite_schema AS t JOIN pragma_table_info(t.name) AS c "
                          "WHERE t.type = 'table' AND c.name = 'dataset_row' ORDER BY t.name"};
  std::vector<Table> tables;
  while (query.step()) tables.push_back(table_of(db, query.text(0)));
  return tables;
}

/// What copies a table, or the R*Tree of its boxes, with the numbers of rows as they are here.
std::string copy(const Table& table, const std::string& into, const std::vector<std::string>& columns,
                 std::int64_t dataset_offset) {
  std::string names;
  std::string values;
  for (const std::string& column : columns) {
    const std::string separator = names.empty() ? "" : ", ";
    names += separator + column;
    values += separator + column;
    if (column == "row") values += " + " + std::to_string(table.row_offset);
    if (column == "dataset_row") values += " + " + std::to_string(dataset_offset);
  }
  return " INTO main." + into + " (" + names + ") SELECT " + values + " FROM arrived." + into + " ";
}

void run_for(sqlite::Connection& db, const std::string& sql, std::int64_t row) {
  sqlite::Statement statement{db, sql};
  statement.bind(1, row);
  statement.run();
}

void take_over(sqlite::Connection& db, const Table& datasets, const std::vector<Table>& tables,
               std::int64_t row) {
  const std::int64_t offset = datasets.row_offset;
  run_for(db, "INSERT" + copy(datasets, datasets.name, datasets.columns, offset) + "WHERE row = ?1", row);
  for (const Table& table : tables) {
    run_for(db, "INSERT" + copy(table, table.name, table.columns, offset) + "WHERE dataset_row = ?1", row);
    const std::string box =
        table.name + "_box";  // an R*Tree; where a trigger has filled it already, with the same
    if (!has_table(db, box)) continue;
    run_for(db,
            "INSERT OR REPLACE" + copy(table, box, columns_of(db, box), offset) +
                "WHERE row IN (SELECT row FROM arrived." + table.name + " WHERE dataset_row = ?1)",
            row);
  }
}

/// The other file was written next to foreign data: a view or a trigger that does not belong there must not run.
void refuse_another_schema(sqlite::Connection& db) {
  sqlite::Statement differing{
      db,
      "SELECT name FROM arrived.sqlite_schema AS there WHERE NOT EXISTS (SELECT 1 FROM "
      "main.sqlite_schema AS here WHERE here.name = there.name AND here.type = there.type "
      "AND here.sql IS there.sql)"};
  if (differing.step())
    throw std::runtime_error{"the data that arrived have tables of another form; ingest the files again"};
}

}  // namespace

std::vector<DatasetId> take_over_datasets(sqlite::Connection& db, const std::filesystem::path& folder) {
  const sqlite::Attachment arrived{db, folder / "floeplan.sqlite", "arrived"};
  sqlite::Transaction transaction{db};
  sqlite::execute(db, "PRAGMA defer_foreign_keys = ON");
  refuse_another_schema(db);
  std::vector<DatasetId> ids;
  {
    const Table datasets = table_of(db, "dataset");
    const std::vector<Table> tables = tables_of_data(db);
    std::vector<std::int64_t> rows;
    sqlite::Statement fresh{
        db, "SELECT row, id FROM arrived.dataset WHERE id NOT IN (SELECT id FROM main.dataset) ORDER BY row"};
    while (fresh.step()) {
      rows.push_back(fresh.integer(0));
      ids.push_back({fresh.text(1)});
    }
    for (const std::int64_t row : rows) take_over(db, datasets, tables, row);
  }
  transaction.commit();
  return ids;
}

}  // namespace floeplan::repository

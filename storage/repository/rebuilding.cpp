#include "storage/repository/rebuilding.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "storage/repository/dataset_tables.hpp"
#include "storage/sqlite/attachment.hpp"
#include "storage/sqlite/database_files.hpp"
#include "storage/sqlite/statement.hpp"
#include "storage/sqlite/transaction.hpp"

namespace floeplan::repository {
namespace {

namespace fs = std::filesystem;

const std::string old = "old";

void run_scripts(sqlite::Connection& db, const std::string& which) {
  std::vector<std::string> scripts;
  {
    sqlite::Statement query{
        db, "SELECT sql FROM old.sqlite_schema AS t WHERE sql IS NOT NULL AND " + which + " ORDER BY rowid"};
    while (query.step()) scripts.push_back(query.text(0));
  }
  for (const std::string& script : scripts) sqlite::execute(db, script);
}

/// R*Trees bring the tables in which they keep themselves.
void make_tables(sqlite::Connection& db) {
  run_scripts(db, ordinary_tables);
  run_scripts(db, "t.sql LIKE 'CREATE VIRTUAL TABLE%'");
}

std::int64_t number_in_header(sqlite::Connection& db, const std::string& pragma) {
  sqlite::Statement query{db, "PRAGMA old." + pragma};
  return query.step() ? query.integer(0) : 0;
}

std::string columns_text(sqlite::Connection& db, const std::string& table) {
  std::string text;
  for (const Column& column : columns_of(db, table)) text += (text.empty() ? "" : ", ") + column.name;
  return text;
}

std::string insert_from_old(sqlite::Connection& db, const std::string& table, const char* index) {
  const std::string columns = columns_text(db, table);
  return "INSERT INTO main." + table + " (" + columns + ") SELECT " + columns + " FROM old." + table + index;
}

void run_with(sqlite::Connection& db, const std::string& sql, std::int64_t row) {
  sqlite::Statement statement{db, sql};
  statement.bind(1, row);
  statement.run();
}

template <class Work>
bool copied_past_indices(sqlite::Connection& db, const Work& work) {
  return past_damaged_indices([&](const char* index) {
    sqlite::Transaction part{db};  // what was copied before it met damage goes again
    work(index);
    part.commit();
  });
}

/// A thing with all that belongs to it; false, and nothing of it, where any is damaged.
bool copy_thing(sqlite::Connection& db, const ThingTable& table, std::int64_t row) {
  sqlite::Transaction thing{db};
  const bool own = meets_no_damage(
      [&] { run_with(db, insert_from_old(db, std::string{table.table}, " ") + "WHERE rowid = ?1", row); });
  if (!own) return false;
  const std::string of_thing = "WHERE " + std::string{table.key} + " = ?1";
  for (const std::string& below : tables_below(db, old, table)) {
    const bool rows = copied_past_indices(
        db, [&](const char* index) { run_with(db, insert_from_old(db, below, index) + of_thing, row); });
    const std::string boxes = boxes_of(below);
    const bool boxes_too = !has_table(db, boxes) || meets_no_damage([&] {
      run_with(db,
               insert_from_old(db, boxes, " ") + "WHERE row IN (SELECT row FROM main." + below + " " +
                   of_thing + ")",
               row);
    });
    if (!rows || !boxes_too) return false;
  }
  thing.commit();
  return true;
}

bool has_row_numbers(sqlite::Connection& db, const std::string& table) {
  sqlite::Statement query{
      db,
      "SELECT 1 FROM old.sqlite_schema WHERE name = ?1 AND type = 'table' AND sql LIKE '%WITHOUT ROWID%'"};
  query.bind(1, table);
  return !query.step();
}

/// A table without things: whole, or row by row as far as it goes.
bool copy_table_beside(sqlite::Connection& db, const std::string& table) {
  const auto copy_all = [&](const char* index) { sqlite::execute(db, insert_from_old(db, table, index)); };
  if (copied_past_indices(db, copy_all)) return true;
  if (!has_row_numbers(db, table)) return false;
  for (const std::int64_t row : rows_of(db, old, table).readable)
    run_with(db, insert_from_old(db, table, " NOT INDEXED ") + "WHERE rowid = ?1", row);
  return false;
}

std::vector<StoredThing> copy_all(sqlite::Connection& db, const core::ProgressCallback& progress) {
  std::vector<StoredThing> lost;
  for (const ThingTable& table : thing_tables) {
    if (!has_table(db, std::string{table.table})) continue;  // of an older schema
    ThingList list = things_in(db, old, table);
    std::ranges::move(list.damaged, std::back_inserter(lost));
    for (std::size_t i = 0; i < list.readable.size(); ++i) {
      if (progress)
        progress("copying every " + std::string{table.kind},
                 static_cast<double>(i) / static_cast<double>(list.readable.size()));
      if (!copy_thing(db, table, list.readable[i].row)) lost.push_back(list.readable[i]);
    }
  }
  for (const std::string& table : tables_beside(db, old))
    if (!copy_table_beside(db, table)) lost.push_back({"part of the table", table, 0});
  return lost;
}

/// Numbers that rows had once are not given again.
void copy_highest_rows(sqlite::Connection& db) {
  const bool whole = meets_no_damage([&] {
    sqlite::Transaction part{db};
    sqlite::execute(db,
                    "DELETE FROM main.sqlite_sequence; INSERT INTO main.sqlite_sequence SELECT * FROM "
                    "old.sqlite_sequence");
    part.commit();
  });
  (void)whole;  // else they follow from the rows that were copied
}

}  // namespace

std::vector<StoredThing> rebuild(const fs::path& from, const fs::path& folder,
                                 const core::ProgressCallback& progress) {
  fs::remove_all(folder);
  auto db = sqlite::Connection::open(folder);
  // Nobody misses it after a kill, and its first page, which says that there are checksums, is written.
  sqlite::execute(db, "PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF; PRAGMA foreign_keys = OFF");
  std::vector<StoredThing> lost;
  {
    const sqlite::Attachment attached{db, from, old};
    sqlite::Transaction transaction{db};
    make_tables(db);
    lost = copy_all(db, progress);
    copy_highest_rows(db);
    run_scripts(db, "type IN ('index', 'trigger')");
    for (const char* const number : {"application_id", "user_version"})
      sqlite::execute(
          db, std::string{"PRAGMA main."} + number + " = " + std::to_string(number_in_header(db, number)));
    transaction.commit();
  }
  sqlite::execute(db, "PRAGMA journal_mode = DELETE");
  return lost;
}

}  // namespace floeplan::repository

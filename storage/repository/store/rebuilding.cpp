#include "storage/repository/store/rebuilding.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "storage/repository/store/dataset_tables.hpp"
#include "storage/sql/attachment.hpp"
#include "storage/sql/copying.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

namespace fs = std::filesystem;

const std::string old = "old";

std::string columns_text(sql::Connection& db, const std::string& table) {
  std::string text;
  for (const sql::Column& column : sql::columns_of(db, table))
    text += (text.empty() ? "" : ", ") + column.name;
  return text;
}

std::string insert_from_old(sql::Connection& db, const std::string& table, const char* index) {
  const std::string columns = columns_text(db, table);
  return "INSERT INTO main." + table + " (" + columns + ") SELECT " + columns + " FROM old." + table + index;
}

void run_with(sql::Connection& db, const std::string& sql, std::int64_t row) {
  sql::Statement statement{db, sql};
  statement.bind(1, row);
  statement.run();
}

template <class Work>
bool copied_past_indices(sql::Connection& db, const Work& work) {
  return sql::past_damaged_indices([&](const char* index) {
    sql::Transaction part{db};  // undoes what was copied before the damage was met
    work(index);
    part.commit();
  });
}

/// Copies a thing with all its rows. If any of them is damaged, copies nothing and returns false.
bool copy_thing(sql::Connection& db, const ThingTable& table, std::int64_t row) {
  sql::Transaction thing{db};
  const bool own = sql::meets_no_damage(
      [&] { run_with(db, insert_from_old(db, std::string{table.table}, " ") + "WHERE rowid = ?1", row); });
  if (!own) return false;
  const std::string of_thing = "WHERE " + std::string{table.key} + " = ?1";
  for (const std::string& below : tables_below(db, old, table)) {
    const bool rows = copied_past_indices(
        db, [&](const char* index) { run_with(db, insert_from_old(db, below, index) + of_thing, row); });
    const std::string boxes = boxes_of(below);
    const bool boxes_too = !sql::has_table(db, boxes) || sql::meets_no_damage([&] {
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

/// Copies a table whose rows belong to no thing: as a whole, or, if that fails, all rows that can be read.
bool copy_table_beside(sql::Connection& db, const std::string& table) {
  const auto copy_all = [&](const char* index) { sql::execute(db, insert_from_old(db, table, index)); };
  if (copied_past_indices(db, copy_all)) return true;
  if (!sql::has_row_numbers(db, old, table)) return false;
  for (const std::int64_t row : sql::rows_of(db, old, table).readable)
    run_with(db, insert_from_old(db, table, sql::without_indices) + "WHERE rowid = ?1", row);
  return false;
}

std::vector<StoredThing> copy_all(sql::Connection& db, const core::ProgressCallback& progress) {
  std::vector<StoredThing> lost;
  for (const ThingTable& table : thing_tables) {
    if (!sql::has_table(db, std::string{table.table})) continue;  // a store of an older schema
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

}  // namespace

std::vector<StoredThing> rebuild(const fs::path& from, const fs::path& folder,
                                 const core::ProgressCallback& progress) {
  fs::remove_all(folder);
  auto db = sql::open_copy(folder);
  std::vector<StoredThing> lost;
  {
    const sql::Attachment attached{db, from, old};
    sql::Transaction transaction{db};
    sql::make_tables_as_in(db, old);
    lost = copy_all(db, progress);
    sql::take_highest_rows_from(db, old);
    sql::make_indices_as_in(db, old);
    sql::take_schema_number_from(db, old);
    transaction.commit();
  }
  sql::finish_copy(db);
  return lost;
}

}  // namespace floeplan::repository

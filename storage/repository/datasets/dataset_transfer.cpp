#include "storage/repository/datasets/dataset_transfer.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "engine/messages/store_messages.hpp"
#include "storage/repository/datasets/copy_to_server.hpp"
#include "storage/repository/datasets/dataset_row.hpp"
#include "storage/repository/store/dataset_tables.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/attachment.hpp"
#include "storage/sql/references.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/store_file.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

/// A table whose rows belong to datasets.
struct Table {
  std::string name;
  std::vector<sql::Column> columns;
  std::int64_t row_offset{};  // added to a row's number in the other store
};

/// The highest row number; 0 for a table whose rows have no numbers.
std::int64_t highest_row(sql::Connection& db, const Table& table) {
  const bool has_numbers = std::ranges::find(table.columns, "row", &sql::Column::name) != table.columns.end();
  return has_numbers ? sql::highest_row(db, table.name) : 0;
}

Table table_of(sql::Connection& db, const std::string& name) {
  Table table{name, sql::columns_of(db, name)};
  table.row_offset = highest_row(db, table);
  return table;
}

/// SQL that copies a table, or the R*Tree of its boxes, and converts row numbers to those of this store.
std::string copy(const Table& table, const std::string& into, const std::vector<sql::Column>& columns,
                 std::int64_t dataset_offset) {
  std::string names;
  std::string values;
  for (const auto& [column, type] : columns) {
    const std::string separator = names.empty() ? "" : ", ";
    names += separator + column;
    values += separator + column;
    if (column == "row") values += " + " + std::to_string(table.row_offset);
    if (column == "dataset_row") values += " + " + std::to_string(dataset_offset);
    // A unique temporary id hides the dataset, because a dataset to be replaced still has the real id.
    if (table.name == "dataset" && column == "id")
      values += " || '~' || (row + " + std::to_string(table.row_offset) + ")";
  }
  return " INTO main." + into + " (" + names + ") SELECT " + values + " FROM arrived." + into + " ";
}

void run_for(sql::Connection& db, const std::string& sql, std::int64_t row) {
  sql::Statement statement{db, sql};
  statement.bind(1, row);
  statement.run();
}

/// A dataset that is being copied; hidden from every list until it is complete.
struct Arrival {
  DatasetId id;
  std::int64_t there{};  // its row in the other store
  std::int64_t here{};
};

/// Rows that are copied before the dataset is shown: its grid and the samples on it, which are nearly all of
/// its size.
constexpr const char* early_table = "grid";
constexpr const char* large_table = "field_chunk";
/// About 10 MB of samples, which hold the write lock for some tens of milliseconds.
constexpr std::int64_t rows_at_once = 1024;
/// Waiting writers retry after at most 25 ms, so one of them can start during the pauses.
constexpr std::chrono::milliseconds least_pause{5};
// seconds after which incomplete data of a dead process are removed
constexpr const char* abandoned_after = "3600";

void remove_arrivals_of_the_dead(sql::Connection& db) {
  const std::string abandoned = std::string{"arriving_s < unixepoch() - "} + abandoned_after;
  sql::Statement any{db, "SELECT 1 FROM main.dataset WHERE " + abandoned};
  if (any.step()) sql::execute(db, "DELETE FROM main.dataset WHERE " + abandoned);
}

/// Datasets that are only in the other store, or are outdated in this store only.
constexpr const char* fresh_datasets =
    "SELECT row, id FROM arrived.dataset AS there WHERE NOT EXISTS (SELECT 1 FROM main.dataset AS here WHERE "
    "here.id = there.id AND here.outdated <= there.outdated) ORDER BY row";

/// Inserts a hidden row for each new dataset, under an id that no other dataset can have.
std::vector<Arrival> announce(sql::Connection& db) {
  sql::Transaction transaction{db};
  const Table datasets = table_of(db, "dataset");
  std::vector<Arrival> arrivals;
  {
    sql::Statement fresh{db, fresh_datasets};
    while (fresh.step())
      arrivals.push_back({{fresh.text(1)}, fresh.integer(0), fresh.integer(0) + datasets.row_offset});
  }
  const Table grids = table_of(db, early_table);
  for (const Arrival& arrival : arrivals) {
    run_for(
        db,
        "INSERT" + copy(datasets, datasets.name, datasets.columns, datasets.row_offset) + "WHERE row = ?1",
        arrival.there);
    run_for(db, "UPDATE main.dataset SET arriving_s = unixepoch() WHERE row = ?1", arrival.here);
    run_for(db,
            "INSERT" + copy(grids, grids.name, grids.columns, arrival.here - arrival.there) +
                "WHERE dataset_row = ?1",
            arrival.there);
  }
  transaction.commit();
  return arrivals;
}

/// Number of the last row in the next batch; empty if all rows are copied.
std::optional<std::int64_t> end_of_batch(sql::Connection& db, const Arrival& arrival, std::int64_t after) {
  // The unary plus prevents use of the index by dataset, whose rows would have to be sorted each time.
  sql::Statement query{db, std::string{"SELECT max(number) FROM (SELECT rowid AS number FROM arrived."} +
                               large_table +
                               " WHERE +dataset_row = ?1 AND rowid > ?2 ORDER BY rowid LIMIT ?3)"};
  query.bind_all(arrival.there, after, rows_at_once);
  if (!query.step() || query.is_null(0)) return std::nullopt;
  return query.integer(0);
}

/// Copies in many short transactions with pauses in between, so that others can write meanwhile.
void copy_samples(sql::Connection& db, const Arrival& arrival) {
  const Table samples = table_of(db, large_table);
  const std::string sql = "INSERT" +
                          copy(samples, samples.name, samples.columns, arrival.here - arrival.there) +
                          "WHERE +dataset_row = ?1 AND rowid > ?2 AND rowid <= ?3";
  std::int64_t after = 0;
  while (const auto last = end_of_batch(db, arrival, after)) {
    const auto begun = std::chrono::steady_clock::now();
    {
      sql::Transaction transaction{db};
      sql::Statement insert{db, sql};
      insert.bind_all(arrival.there, after, *last);
      insert.run();
      run_for(db, "UPDATE main.dataset SET arriving_s = unixepoch() WHERE row = ?1", arrival.here);
      transaction.commit();
    }
    after = *last;
    const auto spent = std::chrono::steady_clock::now() - begun;
    std::this_thread::sleep_for(std::max<std::chrono::steady_clock::duration>(least_pause, spent / 2));
  }
}

void copy_the_rest(sql::Connection& db, const Arrival& arrival) {
  for (const std::string& name : tables_of_data(db)) {
    if (name == early_table || name == large_table) continue;
    const Table table = table_of(db, name);
    const std::int64_t offset = arrival.here - arrival.there;
    run_for(db, "INSERT" + copy(table, table.name, table.columns, offset) + "WHERE dataset_row = ?1",
            arrival.there);
    const std::string box = boxes_of(table.name);  // a trigger may already have inserted the same box
    if (!sql::has_table(db, box)) continue;
    run_for(db,
            "INSERT OR REPLACE" + copy(table, box, sql::columns_of(db, box), offset) +
                "WHERE row IN (SELECT row FROM arrived." + table.name + " WHERE dataset_row = ?1)",
            arrival.there);
  }
}

void remove_row(sql::Connection& db, const Arrival& arrival) {
  run_for(db, "DELETE FROM main.dataset WHERE row = ?1", arrival.here);
}

/// Shows all datasets at once. A dataset that another process has stored meanwhile is kept.
std::vector<DatasetId> show(sql::Connection& db, const std::vector<Arrival>& arrivals) {
  sql::Transaction transaction{db};
  sql::defer_references(db);
  std::vector<DatasetId> ids;
  for (const Arrival& arrival : arrivals) {
    run_for(db,
            "DELETE FROM main.dataset WHERE outdated = 1 AND id = (SELECT id FROM arrived.dataset WHERE row "
            "= ?1)",
            arrival.there);
    if (find_dataset_row(db, arrival.id)) {
      remove_row(db, arrival);
      continue;
    }
    copy_the_rest(db, arrival);
    sql::Statement reveal{db, "UPDATE main.dataset SET id = ?2, arriving_s = NULL WHERE row = ?1"};
    reveal.bind_all(arrival.here, arrival.id.value);
    if (reveal.run() != 1) throw std::runtime_error{messages::store_text<"data-removed-meanwhile">()};
    ids.push_back(arrival.id);
  }
  transaction.commit();
  return ids;
}

/// Checks the schema of the other file. It was written beside data from outside: unexpected views or triggers
/// must not run.
void refuse_another_schema(sql::Connection& db) {
  if (!sql::has_only_tables_of_main(db, "arrived"))
    throw std::runtime_error{messages::store_text<"data-of-another-form">()};
}

}  // namespace

std::vector<DatasetId> take_over_datasets(sql::Connection& db, const std::filesystem::path& folder) {
  if (db.engine() == sql::Engine::server) {
    sql::Connection reader = open_store_in_memory();
    const sql::Attachment arrived{reader, sql::database_in(folder), "arrived"};
    refuse_another_schema(reader);
    return copy_to_server(reader, db);
  }
  const sql::Attachment arrived{db, sql::database_in(folder), "arrived"};
  refuse_another_schema(db);
  remove_arrivals_of_the_dead(db);
  const std::vector<Arrival> arrivals = announce(db);
  try {
    for (const Arrival& arrival : arrivals) copy_samples(db, arrival);
    return show(db, arrivals);
  } catch (...) {
    for (const Arrival& arrival : arrivals) remove_row(db, arrival);
    throw;
  }
}

}  // namespace floeplan::repository

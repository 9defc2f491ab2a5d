#include "storage/repository/store/store_copy.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/messages/store_messages.hpp"
#include "storage/repository/store/dataset_tables.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/sql/references.hpp"
#include "storage/sql/copies/copied_value.hpp"
#include "storage/sql/copies/row_stream.hpp"
#include "storage/sql/copies/rows_digest.hpp"
#include "storage/sql/snapshot.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/tables.hpp"
#include "storage/sql/transaction.hpp"
#include "storage/sql/copies/without_triggers.hpp"

namespace floeplan::repository {
namespace {

/// It has one row in an empty store, too.
constexpr const char* clock_of_jobs = "job_clock";

/// The tables that every store has.
std::vector<std::string> all_tables() {
  sql::Connection store = open_store_in_memory();
  return sql::tables_of(store, "main", "");
}

std::string listed(const std::vector<sql::Column>& columns) {
  std::string names;
  for (const sql::Column& column : columns) names += (names.empty() ? "" : ", ") + column.name;
  return names;
}

void refuse_used_store(sql::Connection& to, const std::vector<std::string>& tables) {
  for (const std::string& table : tables) {
    if (table == clock_of_jobs) continue;
    sql::Statement query{to, "SELECT 1 FROM " + table + " LIMIT 1"};
    if (query.step()) throw std::runtime_error{messages::store_text<"copy-into-used-store">(table)};
  }
}

/// Copies all rows of a table. Returns their digest.
sql::RowsDigest copy_rows(sql::Connection& from, sql::Connection& to, const std::string& table) {
  const std::vector<sql::Column> columns = sql::columns_of(from, table);
  const std::string names = listed(columns);
  std::string values;
  for (std::size_t i = 0; i < columns.size(); ++i) values += (i == 0 ? "?" : ", ?") + std::to_string(i + 1);
  sql::Statement insert{to, "INSERT INTO " + table + " (" + names + ") VALUES (" + values + ")"};
  sql::RowsDigest digest;
  sql::for_each_row(from, "of_" + table, "SELECT " + names + " FROM " + table, [&](const sql::Row& row) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      sql::bind_copy(insert, static_cast<int>(i) + 1, row, static_cast<int>(i), columns[i].type);
    insert.run();
    digest.add(row, columns);
  });
  return digest;
}

/// Reads a table of the copy, its columns as `from` has them.
sql::RowsDigest digest_of(sql::Connection& from, sql::Connection& to, const std::string& table) {
  const std::vector<sql::Column> columns = sql::columns_of(from, table);
  sql::RowsDigest digest;
  sql::for_each_row(to, "in_" + table, "SELECT " + listed(columns) + " FROM " + table,
                    [&](const sql::Row& row) { digest.add(row, columns); });
  return digest;
}

/// Copies the tables; an embedded engine rounds the boxes outwards, so that their number alone is compared.
class StoreCopy {
 public:
  StoreCopy(sql::Connection& from, sql::Connection& to) : from_{from}, to_{to} {}

  void copy(const std::string& table) {
    copied_.emplace(table, copy_rows(from_, to_, table));
    if (has_numbers(table)) sql::continue_rows(to_, table, sql::highest_row(from_, table));
    if (const std::string box = boxes_of(table); sql::has_table(from_, box))
      boxes_.emplace(box, copy_rows(from_, to_, box).count());
  }

  void compare(const std::string& table) {
    const std::string box = boxes_of(table);
    const auto count = boxes_.find(box);
    if (digest_of(from_, to_, table) != copied_.at(table) ||
        (count != boxes_.end() && digest_of(from_, to_, box).count() != count->second))
      throw std::runtime_error{messages::store_text<"copy-differs">(table)};
  }

  [[nodiscard]] CopiedStore report() const {
    CopiedStore report{.rows = 0,
                       .datasets = copied_.at("dataset").count(),
                       .plans = copied_.at("plan").count(),
                       .jobs = copied_.at("job").count()};
    for (const auto& [table, digest] : copied_) report.rows += digest.count();
    return report;
  }

 private:
  bool has_numbers(const std::string& table) {
    return std::ranges::any_of(sql::columns_of(from_, table),
                               [](const sql::Column& column) { return column.name == "row"; });
  }

  sql::Connection& from_;  // borrowed
  sql::Connection& to_;    // borrowed
  std::map<std::string, sql::RowsDigest> copied_;
  std::map<std::string, std::int64_t> boxes_;  // numbers of rows
};

}  // namespace

CopiedStore copy_store(sql::Connection& from, sql::Connection& to, const core::ProgressCallback& progress) {
  const std::vector<std::string> tables = all_tables();
  const sql::Snapshot one_moment{from};
  sql::Transaction transaction{to};
  sql::defer_references(to);
  refuse_used_store(to, tables);
  sql::WithoutTriggers without_triggers{to, tables};
  sql::execute(to, std::string{"DELETE FROM "} + clock_of_jobs);
  StoreCopy copy{from, to};
  double done = 0.0;
  const auto told = [&](const char* stage, const std::string& table) {
    if (progress) progress(std::string{stage} + ": " + table, done++ / (2.0 * static_cast<double>(tables.size())));
  };
  for (const std::string& table : tables) {
    told("copying", table);
    copy.copy(table);
  }
  for (const std::string& table : tables) {
    told("comparing", table);
    copy.compare(table);
  }
  without_triggers.end();
  transaction.commit();
  return copy.report();
}

}  // namespace floeplan::repository

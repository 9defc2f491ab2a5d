#include "storage/repository/datasets/copy_to_server.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "storage/repository/store/dataset_tables.hpp"
#include "storage/sql/copies/copied_value.hpp"
#include "storage/sql/references.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

using NewNumbers = std::map<std::int64_t, std::int64_t>;  // by the row's number in the store that arrived

/// Copies rows of one table. Where rows have numbers the server gives them new ones.
class TableCopy {
 public:
  /// `condition`    which rows, by the parameter ?1
  /// `on_conflict`  what happens with rows that are there already; empty: they are an error
  TableCopy(sql::Connection& arrived, sql::Connection& server, const std::string& table,
            const std::string& condition, const std::string& on_conflict = "")
      : columns_{sql::columns_of(arrived, table)} {
    std::string all;
    std::string names;
    std::string values;
    for (const sql::Column& column : columns_) {
      all += (all.empty() ? "" : ", ") + column.name;
      if (column.name == "row" && !keeps_numbers(table)) continue;
      names += (names.empty() ? "" : ", ") + column.name;
      values += (values.empty() ? "?" : ", ?") + std::to_string(++parameters_);
    }
    rows_.emplace(arrived, "SELECT " + all + " FROM arrived." + table + " WHERE " + condition);
    gives_numbers_ = parameters_ < static_cast<int>(columns_.size());
    insert_.emplace(server, "INSERT INTO " + table + " (" + names + ") VALUES (" + values + ") " +
                                on_conflict + (gives_numbers_ ? " RETURNING row" : ""));
  }

  /// `rows`  new numbers of rows that are kept: of the rows themselves in a table of boxes
  /// Returns  the new numbers that the server gave; none where the rows have none, or were there already
  NewNumbers run(std::int64_t chosen, std::int64_t dataset, const NewNumbers& rows = {}) {
    NewNumbers given;
    rows_->reset();
    rows_->bind(1, chosen);
    while (rows_->step()) {
      std::int64_t old = 0;
      int parameter = 0;
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        const int column = static_cast<int>(i);
        const std::string& name = columns_[i].name;
        if (name == "row") {
          old = rows_->integer(column);
          if (gives_numbers_) continue;
          insert_->bind(++parameter, rows.at(old));
        } else if (name == "dataset_row") {
          insert_->bind(++parameter, dataset);
        } else {
          sql::bind_copy(*insert_, ++parameter, *rows_, column, columns_[i].type);
        }
      }
      if (!gives_numbers_) {
        insert_->run();
      } else if (insert_->step()) {
        given.emplace(old, insert_->integer(0));
      }
      insert_->reset();
    }
    return given;
  }

 private:
  /// Boxes have the numbers of the rows that they are boxes of.
  static bool keeps_numbers(const std::string& table) { return table.ends_with(boxes_of("")); }

  std::vector<sql::Column> columns_;
  std::optional<sql::Statement> rows_;
  std::optional<sql::Statement> insert_;
  int parameters_{0};
  bool gives_numbers_{};
};

void copy_data(sql::Connection& arrived, sql::Connection& server, std::int64_t there, std::int64_t here) {
  for (const std::string& name : tables_of_data(arrived)) {
    TableCopy rows{arrived, server, name, "dataset_row = ?1"};
    const NewNumbers given = rows.run(there, here);
    const std::string box = boxes_of(name);
    if (!sql::has_table(arrived, box)) continue;
    // A trigger may have filled the box of a row already, with the same.
    TableCopy boxes{arrived, server, box,
                    "row IN (SELECT row FROM arrived." + name + " WHERE dataset_row = ?1)",
                    "ON CONFLICT (row) DO NOTHING"};
    (void)boxes.run(there, here, given);
  }
}

}  // namespace

std::vector<DatasetId> copy_to_server(sql::Connection& arrived, sql::Connection& server) {
  sql::Transaction transaction{server, sql::WriteTurn::beside_others};
  sql::defer_references(server);
  sql::Statement replaced{server, "DELETE FROM dataset WHERE id = ?1 AND outdated > ?2"};
  TableCopy datasets{arrived, server, "dataset", "row = ?1", "ON CONFLICT (id) DO NOTHING"};
  sql::Statement all{arrived, "SELECT row, id, outdated FROM arrived.dataset ORDER BY row"};
  std::vector<DatasetId> ids;
  while (all.step()) {
    const std::int64_t there = all.integer(0);
    replaced.bind_all(all.text(1), all.integer(2));
    replaced.run();
    const NewNumbers given = datasets.run(there, 0);
    if (given.empty()) continue;  // it is here, or another process has stored it meanwhile
    copy_data(arrived, server, there, given.at(there));
    ids.push_back({all.text(1)});
  }
  transaction.commit();
  return ids;
}

}  // namespace floeplan::repository

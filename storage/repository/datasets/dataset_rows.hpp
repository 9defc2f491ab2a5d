#pragma once

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/store/dataset_tables.hpp"
#include "storage/sql/connection.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {

/// How data leave a process that has read foreign bytes: as rows of plain values. A database that such a process wrote
/// is never opened by another one.
///
/// A parcel holds rows of one table: the name of the table (one byte for its length), then the values of row after row,
/// each one byte that says whether it is there, and, by the type of its column here, an integer or a number of 8 bytes,
/// or 4 bytes for a length and as many of a text or blob. Both processes run the same program on the same machine.

/// No parcel is larger: nearly all are about a megabyte, but one row is never divided.
inline constexpr std::size_t largest_parcel_bytes = std::size_t{256} << 20;

/// Hands over all rows of these datasets, parcel by parcel.
void send_datasets(sql::Connection& db, const std::vector<DatasetId>& ids,
                   const std::function<void(std::string_view parcel)>& send);

/// What a parcel holds cannot have been sent by send_datasets: its sender is broken.
struct BrokenParcel : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Puts rows into an empty scratch store of this process's own, by this program's schema alone.
class DatasetReceiver {
 public:
  /// `db`  outlives this
  explicit DatasetReceiver(sql::Connection& db);

  /// Errors   BrokenParcel for an unknown table, a value that is none, a row that the schema does not take;
  ///          sql::Failure when the disk is full
  void take(std::string_view parcel);

  /// Commits all that came.
  /// Returns  the ids of the datasets
  /// Errors   BrokenParcel where rows belong to a dataset that did not come, or a dataset cannot be
  [[nodiscard]] std::vector<DatasetId> finish();

 private:
  struct Table {
    std::vector<sql::Column> columns;
    std::unique_ptr<sql::Statement> insert;
  };

  void open_table(const std::string& name);
  void insert_row(Table& table, std::string_view& values);

  sql::Connection& db_;  // borrowed
  std::map<std::string, Table, std::less<>> tables_;
  sql::Transaction transaction_;
};

}  // namespace floeplan::repository

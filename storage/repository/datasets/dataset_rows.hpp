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

/// Data leave a process that reads files from outside as rows of plain values. A database file that such a
/// process wrote is never opened by another process.
///
/// A parcel holds rows of one table: the name of the table (one byte for its length), then the values row by
/// row. Each value has one byte that tells whether it is null; then, by the type of its column in this
/// schema, 8 bytes of an integer or a floating point number, or 4 bytes for the length of a text or blob and
/// its bytes. Both processes run the same program on the same machine.

/// The largest parcel. Most have about a megabyte, but a single row is never divided.
inline constexpr std::size_t largest_parcel_bytes = std::size_t{256} << 20;

/// Passes all rows of these datasets to `send`, parcel by parcel.
void send_datasets(sql::Connection& db, const std::vector<DatasetId>& ids,
                   const std::function<void(std::string_view parcel)>& send);

/// Thrown when a parcel cannot come from send_datasets, so that its sender must be broken.
struct BrokenParcel : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Puts rows into an empty scratch store of this process, which has this program's own schema.
class DatasetReceiver {
 public:
  /// `db`  must live longer than this object
  explicit DatasetReceiver(sql::Connection& db);

  /// Adds the rows of a parcel.
  /// Errors   BrokenParcel for an unknown table, an invalid value, or a row that violates the schema;
  ///          sql::Failure when the disk is full
  void take(std::string_view parcel);

  /// Commits all rows received.
  /// Returns  the ids of the datasets
  /// Errors   BrokenParcel when rows belong to a dataset that was not sent, or when a dataset is invalid
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

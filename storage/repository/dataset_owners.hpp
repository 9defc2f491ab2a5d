#pragma once

#include <cstdint>
#include <string>

#include "storage/repository/dataset.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::repository {

/// Who sent the files of which datasets over HTTP. What the operator reads from the command line or a watched folder, and
/// what was stored before owners were known, has none.
/// Threads  as the connection: one thread at a time
class DatasetOwners {
 public:
  explicit DatasetOwners(sqlite::Connection& db) : db_{db} {}

  /// Of a dataset that has no owner yet; otherwise nothing changes.
  void note(const DatasetId& id, const std::string& owner);
  /// Of the files of all datasets of the owner, as they were sent.
  [[nodiscard]] std::uint64_t bytes_of(const std::string& owner) const;

 private:
  sqlite::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

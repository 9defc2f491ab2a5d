#pragma once

#include <cstdint>
#include <vector>

#include "storage/sql/statement.hpp"
#include "storage/sql/tables.hpp"

namespace floeplan::sql {

/// A digest of rows in any order, and their number: two tables with the same digest have the same rows, whichever engine
/// keeps them. It detects faults, not forgery.
class RowsDigest {
 public:
  /// `columns`  those of the row, in their order
  void add(const Row& row, const std::vector<Column>& columns);

  [[nodiscard]] std::int64_t count() const { return count_; }
  friend bool operator==(const RowsDigest&, const RowsDigest&) = default;

 private:
  std::int64_t count_{0};
  std::uint64_t low_{0};  // sums of the digests of the rows
  std::uint64_t high_{0};
};

}  // namespace floeplan::sql

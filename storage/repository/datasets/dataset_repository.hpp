#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/repository/store/partial_list.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// The list of datasets.
/// Threads  as the connection: one thread at a time
class DatasetRepository {
 public:
  explicit DatasetRepository(sql::Connection& db) : db_{db} {}

  void insert(const Dataset& dataset);
  /// States bounds, period, rows and provenance of the dataset anew.
  void update(const Dataset& dataset);
  [[nodiscard]] std::optional<Dataset> find(const DatasetId& id) const;
  /// Newest first; ties by id.
  [[nodiscard]] std::vector<Dataset> list() const;
  /// The same, past datasets of which the description is damaged; what they hold is not read.
  [[nodiscard]] PartialList<Dataset> list_past_damage() const;
  /// The ids of all datasets with the digests of their contents, in one text that changes with any of them.
  [[nodiscard]] std::string contents() const;
  /// Removes the dataset and everything that belongs to it. False when there is none.
  bool remove(const DatasetId& id);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

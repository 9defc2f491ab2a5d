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
  /// Replaces the stored bounds, period, number of rows and provenance of a dataset.
  void update(const Dataset& dataset);
  [[nodiscard]] std::optional<Dataset> find(const DatasetId& id) const;
  /// Newest first; ties by id.
  [[nodiscard]] std::vector<Dataset> list() const;
  /// The same list without datasets whose entry is damaged. The data themselves are not checked.
  [[nodiscard]] PartialList<Dataset> list_past_damage() const;
  /// The areas that all datasets of a kind cover, without reading their other entries.
  [[nodiscard]] std::vector<geo::BoundingBox> areas(DatasetKind kind) const;
  /// A text of the ids of all datasets and the digests of their contents; it changes whenever a dataset
  /// changes.
  [[nodiscard]] std::string contents() const;
  /// Removes the dataset and all its data. False if there is no such dataset.
  bool remove(const DatasetId& id);

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/ice/iceberg.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// One stored sighting.
struct StoredSighting {
  std::int64_t row{};  // stable, ascending in the order of insertion: the key to page by
  DatasetId dataset;
  ocean::Iceberg iceberg;
};

/// Which sightings a list wants. Everything empty: all.
struct SightingFilter {
  std::optional<geo::BoundingBox> area{};
  std::optional<core::UtcTime> from{};
  std::optional<core::UtcTime> to{};
  std::optional<DatasetId> dataset{};
  std::optional<std::string> berg_id{};
};

/// Sightings of icebergs, indexed by place (R*Tree) and time. However a source counts longitudes, those read back are
/// within [-180, 180].
/// Threads  as the connection: one thread at a time
class IcebergRepository {
 public:
  explicit IcebergRepository(sql::Connection& db) : db_{db} {}

  void insert(const DatasetId& dataset, const std::vector<ocean::Iceberg>& sightings);
  /// One sighting more; returns its row.
  std::int64_t add(const DatasetId& dataset, const ocean::Iceberg& sighting);
  /// False when there is no such row.
  bool replace(std::int64_t row, const ocean::Iceberg& sighting);
  bool remove(std::int64_t row);
  [[nodiscard]] std::optional<StoredSighting> find(std::int64_t row) const;
  /// At most `limit` sightings with a row above `after`, by ascending row.
  [[nodiscard]] std::vector<StoredSighting> list(const SightingFilter& filter, std::int64_t after,
                                                 int limit) const;
  [[nodiscard]] std::int64_t count(const SightingFilter& filter) const;
  /// Where the berg of a sighting was seen before it, no longer ago than `max_age` before it: oldest first, one fix
  /// for each moment, none for a berg without a name.
  [[nodiscard]] std::vector<ocean::IcebergFix> earlier(const StoredSighting& sighting,
                                                       core::Seconds max_age) const;
  /// For each berg of the dataset, its newest sighting that is not after `as_of` and not older than `max_age`
  /// before it; in the area; by ascending row.
  [[nodiscard]] std::vector<StoredSighting> latest(const DatasetId& dataset, const geo::BoundingBox& area,
                                                   core::UtcTime as_of, core::Seconds max_age) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

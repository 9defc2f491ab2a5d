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
  std::int64_t row{};  // stable, ascending in the order of insertion; used as the key for paging
  DatasetId dataset;
  ocean::Iceberg iceberg;
};

/// Conditions for a list of sightings. Empty members are no condition.
struct SightingFilter {
  std::optional<geo::BoundingBox> area{};
  std::optional<core::UtcTime> from{};
  std::optional<core::UtcTime> to{};
  std::optional<DatasetId> dataset{};
  std::optional<std::string> berg_id{};
};

/// Sightings of icebergs, indexed by position (R*Tree) and time. Longitudes read back are within [-180, 180],
/// whatever the source used.
/// Threads  as the connection: one thread at a time
class IcebergRepository {
 public:
  explicit IcebergRepository(sql::Connection& db) : db_{db} {}

  void insert(const DatasetId& dataset, const std::vector<ocean::Iceberg>& sightings);
  /// Adds a sighting; returns its row.
  std::int64_t add(const DatasetId& dataset, const ocean::Iceberg& sighting);
  /// Replaces a sighting. False if there is no such row.
  bool replace(std::int64_t row, const ocean::Iceberg& sighting);
  bool remove(std::int64_t row);
  [[nodiscard]] std::optional<StoredSighting> find(std::int64_t row) const;
  /// At most `limit` sightings with a row above `after`, by ascending row.
  [[nodiscard]] std::vector<StoredSighting> list(const SightingFilter& filter, std::int64_t after,
                                                 int limit) const;
  [[nodiscard]] std::int64_t count(const SightingFilter& filter) const;
  /// Earlier fixes of the berg of a sighting, up to `max_age` before it: oldest first, one for each time;
  /// none for a berg without a name.
  [[nodiscard]] std::vector<ocean::IcebergFix> earlier(const StoredSighting& sighting,
                                                       core::Seconds max_age) const;
  /// For each berg of the dataset the newest sighting in the period from `max_age` before `as_of` to `as_of`,
  /// if it is in the area; in ascending order of the row.
  [[nodiscard]] std::vector<StoredSighting> latest(const DatasetId& dataset, const geo::BoundingBox& area,
                                                   core::UtcTime as_of, core::Seconds max_age) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

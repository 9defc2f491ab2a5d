#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/zone.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Largest number of zone corners of one plan or one file, because every leg is tested against the corners of
/// zones with a period.
inline constexpr std::size_t max_zone_corners = 100'000;

/// One stored zone.
struct StoredZone {
  std::int64_t row{};  // stable, ascending in the order of insertion; used as the key for paging
  DatasetId dataset;
  ocean::Zone zone;
};

/// Conditions for a list of zones. Empty members are no condition.
struct ZoneFilter {
  std::optional<geo::BoundingBox> area{};
  std::optional<core::UtcTime> from{};  // in force at some time from here on
  std::optional<core::UtcTime> to{};
  std::optional<DatasetId> dataset{};
  std::optional<std::string> kind{};
  std::optional<std::string> name{};
};

/// Zones, indexed by their boxes (R*Tree).
/// Threads  as the connection: one thread at a time
class ZoneRepository {
 public:
  explicit ZoneRepository(sql::Connection& db) : db_{db} {}

  void insert(const DatasetId& dataset, const std::vector<ocean::Zone>& zones);
  /// Adds a zone; returns its row.
  std::int64_t add(const DatasetId& dataset, const ocean::Zone& zone);
  /// Replaces a zone. False if there is no such row.
  bool replace(std::int64_t row, const ocean::Zone& zone);
  bool remove(std::int64_t row);
  [[nodiscard]] std::optional<StoredZone> find(std::int64_t row) const;
  /// At most `limit` zones with a row above `after`, by ascending row.
  [[nodiscard]] std::vector<StoredZone> list(const ZoneFilter& filter, std::int64_t after, int limit) const;
  [[nodiscard]] std::int64_t count(const ZoneFilter& filter) const;
  /// The zones of the dataset that matter in the area from a time on, in the order of insertion: no-go zones
  /// whose box intersects the area, and all stay-in zones, because a vehicle outside of all of them violates
  /// their rule anywhere.
  [[nodiscard]] std::vector<ocean::Zone> load(const DatasetId& dataset, const geo::BoundingBox& area,
                                              core::UtcTime from) const;
  /// All zones that contain the place, whether in force or not; in the order of insertion.
  [[nodiscard]] std::vector<ocean::Zone> at(const DatasetId& dataset, geo::LonLat place) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

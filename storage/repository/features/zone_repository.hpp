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

/// Corners of the zones that one plan, or one file, may have: they are tested for every leg where a zone has its
/// times.
inline constexpr std::size_t max_zone_corners = 100'000;

/// One stored zone.
struct StoredZone {
  std::int64_t row{};  // stable, ascending in the order of insertion: the key to page by
  DatasetId dataset;
  ocean::Zone zone;
};

/// Which zones a list wants. Everything empty: all.
struct ZoneFilter {
  std::optional<geo::BoundingBox> area{};
  std::optional<core::UtcTime> from{};  // in force at some moment from here on
  std::optional<core::UtcTime> to{};
  std::optional<DatasetId> dataset{};
  std::optional<std::string> kind{};
  std::optional<std::string> name{};
};

/// Areas with a rule, indexed by their boxes (R*Tree).
/// Threads  as the connection: one thread at a time
class ZoneRepository {
 public:
  explicit ZoneRepository(sql::Connection& db) : db_{db} {}

  void insert(const DatasetId& dataset, const std::vector<ocean::Zone>& zones);
  /// One zone more; returns its row.
  std::int64_t add(const DatasetId& dataset, const ocean::Zone& zone);
  /// False when there is no such row.
  bool replace(std::int64_t row, const ocean::Zone& zone);
  bool remove(std::int64_t row);
  [[nodiscard]] std::optional<StoredZone> find(std::int64_t row) const;
  /// At most `limit` zones with a row above `after`, by ascending row.
  [[nodiscard]] std::vector<StoredZone> list(const ZoneFilter& filter, std::int64_t after, int limit) const;
  [[nodiscard]] std::int64_t count(const ZoneFilter& filter) const;
  /// What of the dataset concerns the area from a moment on, in the order of insertion: the no-go zones whose box meets
  /// the area, and every stay-in zone, because a vehicle outside all of them breaks their rule wherever it is.
  [[nodiscard]] std::vector<ocean::Zone> load(const DatasetId& dataset, const geo::BoundingBox& area,
                                              core::UtcTime from) const;
  /// Every zone that holds the place, whenever it is in force; in the order of insertion.
  [[nodiscard]] std::vector<ocean::Zone> at(const DatasetId& dataset, geo::LonLat place) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

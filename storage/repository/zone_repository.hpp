#pragma once

#include <cstddef>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/zone.hpp"
#include "storage/repository/dataset.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::repository {

/// Corners of the zones that one plan, or one file, may have: they are tested for every leg where a zone has its
/// times.
inline constexpr std::size_t max_zone_corners = 100'000;

/// Areas with a rule, indexed by their boxes (R*Tree).
/// Threads  as the connection: one thread at a time
class ZoneRepository {
 public:
  explicit ZoneRepository(sqlite::Connection& db) : db_{db} {}

  void insert(const DatasetId& dataset, const std::vector<ocean::Zone>& zones);
  /// What of the dataset concerns the area from a moment on, in the order of insertion: the no-go zones whose box meets
  /// the area, and every stay-in zone, because a vehicle outside all of them breaks their rule wherever it is.
  [[nodiscard]] std::vector<ocean::Zone> load(const DatasetId& dataset, const geo::BoundingBox& area,
                                              core::UtcTime from) const;
  /// Every zone that holds the place, whenever it is in force; in the order of insertion.
  [[nodiscard]] std::vector<ocean::Zone> at(const DatasetId& dataset, geo::LonLat place) const;

 private:
  sqlite::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

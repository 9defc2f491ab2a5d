#pragma once

#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"
#include "storage/repository/dataset.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::repository {

/// Land polygons, indexed by their boxes (R*Tree).
/// Threads  as the connection: one thread at a time
class CoastlineRepository {
 public:
  explicit CoastlineRepository(sqlite::Connection& db) : db_{db} {}

  void insert(const DatasetId& dataset, const std::vector<geo::Polygon>& land);
  /// Every polygon whose box meets the area, whole, in the order of insertion.
  [[nodiscard]] std::vector<geo::Polygon> load(const DatasetId& dataset, const geo::BoundingBox& area) const;

 private:
  sqlite::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

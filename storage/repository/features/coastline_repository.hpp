#pragma once

#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/polygon.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Name of the only variable of a coastline dataset with ice shelves and no land. Such a dataset is used
/// together with the newest coastline and does not replace it.
inline constexpr const char* ice_shelves_alone = "ice_shelf";

/// Keeps the first coastline of a list and all datasets with ice shelves only, because they do not replace
/// land.
void keep_newest_coastline(std::vector<Dataset>& datasets);

/// Land polygons, indexed by their boxes (R*Tree).
/// Threads  as the connection: one thread at a time
class CoastlineRepository {
 public:
  explicit CoastlineRepository(sql::Connection& db) : db_{db} {}

  void insert(const DatasetId& dataset, const std::vector<geo::Polygon>& land);
  /// All polygons whose box intersects the area, uncut, in the order of insertion.
  [[nodiscard]] std::vector<geo::Polygon> load(const DatasetId& dataset, const geo::BoundingBox& area) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository

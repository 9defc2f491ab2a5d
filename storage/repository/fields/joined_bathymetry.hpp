#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Depths of every dataset that has some in an area.
struct JoinedBathymetry {
  ocean::Bathymetry depths;
  std::vector<DatasetId>
      datasets;  // that are used, the one that comes first where several know a depth in front
};

/// The depths of an area for those who look at it from afar: of all bathymetry stored, the finest first as for plans,
/// on no more than about `most_nodes` nodes. Where a dataset has several nodes in a cell, the depth is their mean.
/// Outside  nullopt when no dataset has a node there
[[nodiscard]] std::optional<JoinedBathymetry> joined_bathymetry(sql::Connection& db,
                                                                const geo::BoundingBox& area,
                                                                std::size_t most_nodes);

}  // namespace floeplan::repository

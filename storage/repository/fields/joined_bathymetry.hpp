#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Depths in an area from all datasets that have some there.
struct JoinedBathymetry {
  ocean::Bathymetry depths;
  std::vector<DatasetId> datasets;  // datasets in use; if several have a depth at a node, the first counts
};

/// The depths of an area for display: from all stored bathymetry, the finest first as in plans, on about
/// `most_nodes` nodes at most. If a dataset has several nodes in a cell, the depth is their mean.
/// Outside  nullopt when no dataset has a node in the area
[[nodiscard]] std::optional<JoinedBathymetry> joined_bathymetry(sql::Connection& db,
                                                                const geo::BoundingBox& area,
                                                                std::size_t most_nodes);

}  // namespace floeplan::repository

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/bed/bathymetry.hpp"

namespace floeplan::repository {

/// Depths of several datasets combined on one grid of longitude and latitude. Each node has the depth of the
/// first dataset with a value. If a dataset has several nodes in a cell, the depth is their mean, and their
/// least depth is kept as well. The depths of a dataset that ends inside a cell also count for the least
/// depth of that cell.
/// Threads  one thread at a time
class BathymetryMosaic {
 public:
  /// An empty mosaic of the area with this spacing, or a larger one if `most_nodes` requires it.
  /// Errors  std::invalid_argument for a spacing that is not positive
  BathymetryMosaic(const geo::BoundingBox& area, core::Metres spacing, std::size_t most_nodes);

  /// Adds the next dataset in order of priority. Returns whether any node uses it.
  bool add(const ocean::Bathymetry& layer);
  /// Whether every node has a depth, so that further datasets are not used.
  [[nodiscard]] bool is_complete() const { return unknown_ == 0; }
  [[nodiscard]] core::Metres spacing() const { return grid_.spacing(); }
  [[nodiscard]] ocean::Bathymetry bathymetry() const { return {grid_, depth_m_, shoalest_m_}; }

 private:
  [[nodiscard]] std::optional<std::size_t> cell_of(geo::LonLat place) const;

  ocean::HorizontalGrid grid_;
  std::vector<float> depth_m_;
  std::vector<float> shoalest_m_;
  std::vector<float> fringe_m_;  // least depth of datasets that end inside the cell; infinite: none
  std::size_t unknown_{};
};

}  // namespace floeplan::repository

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/bed/bathymetry.hpp"

namespace floeplan::repository {

/// Depths of several datasets over one area, put together on one grid of longitude and latitude: at each node those of
/// the first dataset that knows any. Where a dataset has several nodes in a cell, the depth is their mean and the least
/// of them is kept beside it; a dataset whose depths end within a cell still bounds the least depth of that cell.
/// Threads  one thread at a time
class BathymetryMosaic {
 public:
  /// An empty mosaic of the area, as fine as `spacing` or as the number of nodes allows.
  /// Errors  std::invalid_argument for a spacing that is not positive
  BathymetryMosaic(const geo::BoundingBox& area, core::Metres spacing, std::size_t most_nodes);

  /// The next dataset in order of priority. Returns whether it is used anywhere.
  bool add(const ocean::Bathymetry& layer);
  /// Whether every node has a depth: what follows is used nowhere.
  [[nodiscard]] bool is_complete() const { return unknown_ == 0; }
  [[nodiscard]] core::Metres spacing() const { return grid_.spacing(); }
  [[nodiscard]] ocean::Bathymetry bathymetry() const { return {grid_, depth_m_, shoalest_m_}; }

 private:
  [[nodiscard]] std::optional<std::size_t> cell_of(geo::LonLat place) const;

  ocean::HorizontalGrid grid_;
  std::vector<float> depth_m_;
  std::vector<float> shoalest_m_;
  std::vector<float> fringe_m_;  // least depth of datasets that end within the cell; infinite: none does
  std::size_t unknown_{};
};

}  // namespace floeplan::repository

#pragma once

#include <cstddef>
#include <memory>
#include <stop_token>
#include <vector>

#include "engine/ocean/bathymetry.hpp"
#include "engine/planning/plane_raster.hpp"

namespace floeplan::planning {

/// The least depth in each cell of a raster over an area (`LeastDepthRows`), for who has to know that the water is deep
/// enough all along a way, and not only where it is looked at.
/// Threads  const members may be called from several threads at once
class BedCells {
 public:
  /// `enough`  the most that is ever asked for. Once `stop` is requested it stays incomplete and must not be used
  BedCells(const ocean::Bathymetry& bathymetry, core::Metres enough, const geo::LocalProjection& projection,
           const PlaneBox& area, core::Metres cell, const std::stop_token& stop);

  /// Whether all of the cell around the point is known and at least so deep; false beyond the area.
  [[nodiscard]] bool is_deep_at(geo::PlanePoint point, core::Metres depth) const;
  /// The same of every cell that the straight line from a to b enters.
  [[nodiscard]] bool is_deep_along(geo::PlanePoint a, geo::PlanePoint b, core::Metres depth) const;
  [[nodiscard]] std::size_t bytes() const { return least_m_.size() * sizeof(float); }

 private:
  PlaneRaster raster_;
  std::vector<float> least_m_;
};

}  // namespace floeplan::planning

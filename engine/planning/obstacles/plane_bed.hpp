#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/planning/plane/plane_grid.hpp"

namespace floeplan::planning::obstacles {

/// The sea bed of a planning area for inner loops: bilinear between the data's nodes. Where the data know
/// their cells to be shoaler than the nodes, the least depth of the cells around the place.
/// Threads  const members may be called from several threads at once
class PlaneBed {
 public:
  /// `bathymetry` must not be null. Once `stop` is requested the bed stays incomplete and must not be used.
  PlaneBed(std::shared_ptr<const ocean::Bathymetry> bathymetry, const geo::LocalProjection& projection,
           const plane::PlaneBox& area, const std::stop_token& stop);

  /// Depth of the sea bed, positive down; empty if unknown.
  [[nodiscard]] std::optional<core::Metres> depth(geo::PlanePoint point) const;
  /// True: the depth is constant within a cell between the data's nodes, and jumps from cell to cell. False:
  /// the depth is continuous, with bends at the cells' sides.
  [[nodiscard]] bool is_stepped() const { return bathymetry_->knows_shoaler_cells(); }
  /// The shares of the straight line from a to b, strictly ascending from the first after 0 to 1, at which it
  /// enters another cell of the data. Further ones are added so that none are further apart than `look`.
  [[nodiscard]] std::vector<double> bends(geo::PlanePoint a, geo::PlanePoint b, core::Metres look) const;
  /// The least depth of all nodes on and around the area; infinite if none is known.
  [[nodiscard]] core::Metres least_depth() const;

 private:
  std::shared_ptr<const ocean::Bathymetry> bathymetry_;
  plane::PlaneGrid grid_;
};

}  // namespace floeplan::planning::obstacles

#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/planning/plane/plane_grid.hpp"

namespace floeplan::planning::obstacles {

/// The sea bed of a planning area as the inner loop asks for it: bilinear between the data's nodes, and where their
/// cells are known to be shoaler, the least of those around the place.
/// Threads  const members may be called from several threads at once
class PlaneBed {
 public:
  /// `bathymetry` must not be null. Once `stop` is requested the bed stays incomplete and must not be used.
  PlaneBed(std::shared_ptr<const ocean::Bathymetry> bathymetry, const geo::LocalProjection& projection,
           const plane::PlaneBox& area, const std::stop_token& stop);

  /// Positive down; empty where it is not known.
  [[nodiscard]] std::optional<core::Metres> depth(geo::PlanePoint point) const;
  /// Whether the depth is the same all over a cell between the data's nodes and jumps from one cell to the next; else
  /// it goes over smoothly and only bends there.
  [[nodiscard]] bool is_stepped() const { return bathymetry_->knows_shoaler_cells(); }
  /// Where the straight line from a to b comes into another cell, and places no further apart than `look`: shares of
  /// its length, strictly ascending, from the first after 0 to 1.
  [[nodiscard]] std::vector<double> bends(geo::PlanePoint a, geo::PlanePoint b, core::Metres look) const;
  /// The least depth of all nodes on and around the area; infinite if none is known.
  [[nodiscard]] core::Metres least_depth() const;

 private:
  std::shared_ptr<const ocean::Bathymetry> bathymetry_;
  plane::PlaneGrid grid_;
};

}  // namespace floeplan::planning::obstacles

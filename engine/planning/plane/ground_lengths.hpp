#pragma once

#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::plane {

/// Converts lengths of straight lines in the plane to lengths on the ground. The scale of the plane varies
/// with the place.
/// Accuracy  the scale is interpolated between 65 x 65 nodes of the area: it is smooth, so its error within a
///           cell is far below the tolerance of travel times
/// Threads   const members may be called from several threads at once
class GroundLengths {
 public:
  GroundLengths(const geo::LocalProjection& projection, const PlaneBox& area);

  [[nodiscard]] core::Metres between(geo::PlanePoint a, geo::PlanePoint b) const;
  /// Lower bound of metres on the ground per metre of the plane, for all lines of this length that begin at
  /// `from`.
  [[nodiscard]] double least_per_plane(geo::PlanePoint from, core::Metres length) const;
  /// Largest scale in the area: metres of the plane per metre on the ground.
  [[nodiscard]] double largest_scale() const { return largest_; }

 private:
  [[nodiscard]] double scale_at(geo::PlanePoint point) const;

  PlaneBox area_;
  std::vector<double> scales_;  // of the projection, [y][x] of the nodes
  double largest_;
  double steepest_;  // largest change of the scale per metre of the plane
};

}  // namespace floeplan::planning::plane

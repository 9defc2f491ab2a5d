#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "engine/geo/local_projection.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::plane {

/// Converts points of the plane to a grid's own coordinates, fast: the smooth map is tabulated and
/// interpolated, so inner loops need no projection.
/// Accuracy h^2 / (8 rho) on the ground for a table step h and a distance rho to the pole of the coordinates:
/// below 1 m at 69 degrees with the steps of at most 2 km used up to 2000 km of extent
/// Edges    geographic longitudes are continuous from the projection's origin, within 180 degrees of it;
///          where they jump (beyond a pole inside the area) the map is computed exactly, and so it is where the area
///          meets the meridian at which a conic or cylindrical projection is cut
/// Threads  const members may be called from several threads at once
class GridLookup {
 public:
  /// Once `stop` is requested the table stays incomplete and must not be used.
  GridLookup(const geo::GridFrame& frame, const geo::LocalProjection& projection, const PlaneBox& area,
             const std::stop_token& stop);

  /// Precondition: `point` lies within the area.
  [[nodiscard]] geo::GridPoint coordinates(geo::PlanePoint point) const;
  /// A point's coordinates, and their change per metre along the plane's axes. Precondition: `has_jump()` is
  /// false.
  struct Surroundings {
    geo::GridPoint at;
    geo::GridPoint per_x_m;
    geo::GridPoint per_y_m;
  };
  [[nodiscard]] Surroundings around(geo::PlanePoint point) const;
  /// Whether coordinates jump somewhere in the area.
  [[nodiscard]] bool has_jump() const { return has_jump_; }
  /// Largest bend of each coordinate: its second derivative along any straight line of the plane, in
  /// coordinate units per square metre. Precondition: `has_jump()` is false.
  [[nodiscard]] geo::GridPoint bend() const;
  /// Largest change of each coordinate per metre of the plane, in any direction. Precondition: `has_jump()`
  /// is false.
  [[nodiscard]] geo::GridPoint steepest() const;
  /// Step of the table, metres of the plane.
  [[nodiscard]] double step_m() const { return 1.0 / inverse_step_; }

 private:
  struct Cell {
    const geo::GridPoint* south_west;
    double fx;
    double fy;
  };
  [[nodiscard]] Cell cell(geo::PlanePoint point) const;
  [[nodiscard]] geo::GridPoint exact(geo::PlanePoint point) const;
  /// Whether the longitudes of neighbouring nodes lie far apart.
  [[nodiscard]] bool jumps_among(const std::vector<double>& longitudes_deg) const;

  geo::FrameProjection frame_;
  bool is_geographic_;
  geo::LocalProjection projection_;
  geo::PlanePoint low_;
  double inverse_step_;
  std::size_t nx_;
  std::size_t ny_;
  bool has_jump_{false};
  std::vector<geo::GridPoint> nodes_;  // [y][x]
};

}  // namespace floeplan::planning::plane

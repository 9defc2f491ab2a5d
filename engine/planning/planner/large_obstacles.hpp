#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/obstacles/closures.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/planning/plane/plane_raster.hpp"
#include "engine/planning/problem/alternative.hpp"

namespace floeplan::planning::planner {

/// A route in the plane with the time at each of its points, counted as in `cost::Sea`. Has at least two
/// points, and no two consecutive points are equal.
struct TimedRoute {
  std::vector<geo::PlanePoint> points;
  std::vector<core::Seconds> times;
};

[[nodiscard]] geo::PlanePoint nearest_point(const TimedRoute& route, geo::PlanePoint place);

/// An obstacle that a route can pass on either side.
struct LargeObstacle {
  ObstacleKind kind{};
  std::vector<geo::PlanePoint> outline;  // convex, counterclockwise; the first point is not repeated
  geo::PlanePoint middle;                // of its bounding box
  geo::PlanePoint nearest;               // centre of its cell nearest to the route
  geo::PlanePoint farthest;              // centre of its cell farthest from the route
  core::Metres extent;                   // longer side of its bounding box, in metres of the plane
  core::Metres from_route;               // distance of `nearest`, in metres of the plane
  /// Whether a vehicle may pass through the obstacle, because it has several parts or drifts.
  bool is_loose{false};
};

/// The closed areas beside a route, as square cells of the plane.
class ObstacleScan {
 public:
  /// A cell is closed if its centre is closed at all times, or at the time when the route is nearest to it.
  /// The model that
  /// `closures` shows must outlive the scan.
  ObstacleScan(const obstacles::Closures& closures, const plane::PlaneBox& area, core::Metres cell,
               const TimedRoute& route);

  /// The obstacles of at least this extent, in the order of their first cell, row by row from the south.
  /// Closed cells with at most three open cells between them belong to one obstacle, unless the route leads
  /// through the gap. Obstacles that touch the rim of the area are left out, because it is unknown how far
  /// they extend.
  [[nodiscard]] std::vector<LargeObstacle> of_at_least(core::Metres extent) const;

  /// The end of a barrier from the obstacle across the route: the first place beyond the route that is closed
  /// at all times, or the rim of the area.
  [[nodiscard]] geo::PlanePoint beyond_route(const LargeObstacle& obstacle) const;

 private:
  /// The kind of obstacle that closes the point; empty if it is open.
  [[nodiscard]] std::optional<ObstacleKind> look_at(geo::PlanePoint point) const;
  [[nodiscard]] bool parted_by_route(std::size_t a, std::size_t b) const;
  /// The closed cells connected with `first` by steps of at most `reach` cells along each axis. Marks them in
  /// `seen`.
  [[nodiscard]] std::vector<std::size_t> joined_to(std::size_t first, std::int64_t reach,
                                                   std::vector<bool>& seen) const;
  [[nodiscard]] LargeObstacle obstacle_of(const std::vector<std::size_t>& cells) const;

  obstacles::Closures closures_;
  TimedRoute route_;
  plane::PlaneRaster raster_;
  std::vector<std::optional<ObstacleKind>> cells_;
  std::vector<bool> on_route_;  // for each cell: whether the route enters it
};

}  // namespace floeplan::planning::planner

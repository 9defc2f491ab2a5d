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

/// A route in the plane with the time at each of its points, counted as in `cost::Sea`. At least two points; neighbours differ.
struct TimedRoute {
  std::vector<geo::PlanePoint> points;
  std::vector<core::Seconds> times;
};

[[nodiscard]] geo::PlanePoint nearest_point(const TimedRoute& route, geo::PlanePoint place);

/// Something that a route can leave on one side or on the other.
struct LargeObstacle {
  ObstacleKind kind{};
  std::vector<geo::PlanePoint> outline;  // convex, counterclockwise; the first point is not repeated
  geo::PlanePoint middle;                // of its bounding box
  geo::PlanePoint nearest;               // middle of its cell that is nearest to the route
  geo::PlanePoint farthest;              // middle of its cell that is farthest from the route
  core::Metres extent;                   // the longer side of its bounding box, metres of the plane
  core::Metres from_route;               // of `nearest`, metres of the plane
  /// Whether a vehicle may find a way through it: it has several parts, or it drifts.
  bool is_loose{false};
};

/// What is closed beside a route, as square cells of the plane.
class ObstacleScan {
 public:
  /// A cell is closed if its middle is closed at all times, or at the time when the route is nearest to it.
  /// What `closures` shows must outlive the scan.
  ObstacleScan(const obstacles::Closures& closures, const plane::PlaneBox& area, core::Metres cell,
               const TimedRoute& route);

  /// The obstacles of at least this extent, in the order of their first cell, row by row from the south. Closed cells with
  /// at most three open cells between them belong to one obstacle, unless the route leads through the gap. Obstacles at the
  /// rim of the area are left out, because what lies behind them is unknown.
  [[nodiscard]] std::vector<LargeObstacle> of_at_least(core::Metres extent) const;

  /// The end of a barrier that leads from the obstacle across the route: the first place behind the route that is closed at
  /// all times, or the rim of the area.
  [[nodiscard]] geo::PlanePoint beyond_route(const LargeObstacle& obstacle) const;

 private:
  /// What closes the point; empty: it is open.
  [[nodiscard]] std::optional<ObstacleKind> look_at(geo::PlanePoint point) const;
  [[nodiscard]] bool parted_by_route(std::size_t a, std::size_t b) const;
  /// The closed cells that can be reached from `first` by steps of at most `reach` cells along each axis. Marks them in
  /// `seen`.
  [[nodiscard]] std::vector<std::size_t> joined_to(std::size_t first, std::int64_t reach,
                                                   std::vector<bool>& seen) const;
  [[nodiscard]] LargeObstacle obstacle_of(const std::vector<std::size_t>& cells) const;

  obstacles::Closures closures_;
  TimedRoute route_;
  plane::PlaneRaster raster_;
  std::vector<std::optional<ObstacleKind>> cells_;
  std::vector<bool> on_route_;  // whether the route enters the cell
};

}  // namespace floeplan::planning::planner

#pragma once

#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/cost/route_grid.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::cost {

/// How far the first grids extend beyond start and goal.
inline constexpr GridReach first_reach{0.5, 0.25};
/// Tried if the first grids hold no route, or if the route runs along their rim.
inline constexpr GridReach second_reach{1.0, 0.75, core::Metres{15'000.0}};

/// The extents of a request's grids, in the order in which they are tried: the two above, or the single one that the
/// request names.
[[nodiscard]] std::vector<GridReach> reaches(const PlanRequest& request);

/// The geometry of a request: its plane, its stops and the grids between them.
struct Layout {
  geo::LocalProjection projection;
  std::vector<geo::LonLat> stops;       // start, via points, goal
  std::vector<geo::PlanePoint> points;  // the stops in the plane
  std::vector<RouteGrid> grids;         // one from each stop to the next

  [[nodiscard]] plane::PlaneBox bounds() const;  // covers all grids
  [[nodiscard]] double most_vertices() const;    // of the largest grid
  [[nodiscard]] core::Metres map_cell() const;   // step of the safety map
  [[nodiscard]] plane::PlaneBox area()
      const;  // of the leg cost model: the grids and two cells of the map around them
};

/// In a plane around the middle of the stops.
/// Precondition  the request is valid
[[nodiscard]] Layout lay_out(const PlanRequest& request, GridReach reach);
/// The same in a given plane.
[[nodiscard]] Layout lay_out(const PlanRequest& request, GridReach reach,
                             const geo::LocalProjection& projection);

/// The centre of the bounding box of start, via points and goal.
[[nodiscard]] geo::LonLat middle_of_stops(const PlanRequest& request);

/// Grid steps for a route of this length: as the request says, or distance/200 between 250 m and 5 km. If the request
/// names the extent of the grid, the steps are large enough to keep the grid at its usual size.
[[nodiscard]] GridSpacing spacing_for(const PlanRequest& request, core::Metres distance);

/// The request with larger grid steps, for searches that do not finish on its own grids.
[[nodiscard]] PlanRequest on_coarser_grids(const PlanRequest& request);

/// The area whose data a plan for the request may use: the bounding box of start, via points and goal with room for
/// detours.
[[nodiscard]] geo::BoundingBox planning_area(const PlanRequest& request);

}  // namespace floeplan::planning::cost

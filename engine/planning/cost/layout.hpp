#pragma once

#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/cost/route_grid.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::cost {

/// Extent of the first grids beyond start and goal; see `GridReach`.
inline constexpr GridReach first_reach{0.5, 0.25};
/// Extent of the second grids. They are tried if the first hold no route, or if the route follows their rim.
inline constexpr GridReach second_reach{1.0, 0.75, core::Metres{15'000.0}};

/// The grid extents to try for a request, in order: the first and the second one, or only the one that the
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
      const;  // area of the leg cost model: all grids with a margin of two cells of the safety map
};

/// The layout in a local plane whose origin is the middle of the stops.
/// Precondition  the request is valid
[[nodiscard]] Layout lay_out(const PlanRequest& request, GridReach reach);
/// The layout in the plane of `projection`.
[[nodiscard]] Layout lay_out(const PlanRequest& request, GridReach reach,
                             const geo::LocalProjection& projection);

/// The centre of the bounding box of start, via points and goal.
[[nodiscard]] geo::LonLat middle_of_stops(const PlanRequest& request);

/// Grid steps for a route of this length: those of the request, otherwise distance/200 between 250 m and 5
/// km. If the request names the extent of the grid, the steps grow so that the grid keeps its usual number of
/// vertices.
[[nodiscard]] GridSpacing spacing_for(const PlanRequest& request, core::Metres distance);

/// The request with larger grid steps, for searches that do not finish on its own grids.
[[nodiscard]] PlanRequest on_coarser_grids(const PlanRequest& request);

/// The area whose data a plan for the request may use: the bounding box of start, via points and goal with room for
/// detours.
[[nodiscard]] geo::BoundingBox planning_area(const PlanRequest& request);

}  // namespace floeplan::planning::cost

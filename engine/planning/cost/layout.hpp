#pragma once

#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/local_projection.hpp"
#include "engine/planning/cost/route_grid.hpp"
#include "engine/planning/plane/plane_box.hpp"
#include "engine/planning/problem/plan_request.hpp"

namespace floeplan::planning::cost {

/// Grids that reach this far are tried first.
inline constexpr GridReach first_reach{0.5, 0.25};
/// Tried when the first leave no way, or when the way runs along their rim.
inline constexpr GridReach second_reach{1.0, 0.75, core::Metres{15'000.0}};

/// The reaches of a request's grids in the order in which they are tried: those two, or a single one with the room that
/// it names.
[[nodiscard]] std::vector<GridReach> reaches(const PlanRequest& request);

/// Where a request takes place: its plane, its stops and the grids between them.
struct Layout {
  geo::LocalProjection projection;
  std::vector<geo::LonLat> stops;       // start, vias, goal
  std::vector<geo::PlanePoint> points;  // the same in the plane
  std::vector<RouteGrid> grids;         // one from each stop to the next

  [[nodiscard]] plane::PlaneBox bounds() const;  // of all grids
  [[nodiscard]] double most_vertices() const;    // of the largest grid
  [[nodiscard]] core::Metres map_cell() const;   // step of the safety map
  [[nodiscard]] plane::PlaneBox area() const;    // of the sea: the grids and two cells of the map around them
};

/// In a plane round the middle of the stops.
/// Precondition: the request is valid.
[[nodiscard]] Layout lay_out(const PlanRequest& request, GridReach reach);
/// The same in a plane that is given.
[[nodiscard]] Layout lay_out(const PlanRequest& request, GridReach reach,
                             const geo::LocalProjection& projection);

/// The middle of the box round start, vias and goal.
[[nodiscard]] geo::LonLat middle_of_stops(const PlanRequest& request);

/// Grid steps for a way of this length: as asked for, or distance/200 within 250 m .. 5 km; with room that is named no
/// less than what keeps the grid as small as usual.
[[nodiscard]] GridSpacing spacing_for(const PlanRequest& request, core::Metres distance);

/// The request on grids of larger steps, for searches that come to no end on those that it would have.
[[nodiscard]] PlanRequest on_coarser_grids(const PlanRequest& request);

/// Area whose data a plan for the request may use: the box around start, vias and goal with room for detours.
[[nodiscard]] geo::BoundingBox planning_area(const PlanRequest& request);

}  // namespace floeplan::planning::cost

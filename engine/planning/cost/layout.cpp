#include "engine/planning/cost/layout.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/planning/plane/lon_lat_box.hpp"

namespace floeplan::planning::cost {
namespace {

constexpr double most_map_cells = 6.4e7;    // of two bytes each: 128 MB
constexpr double map_cells_per_step = 3.0;  // so that a passage as wide as a grid step stays open in the map

// Spacing if the request gives none: part of the contract of the command line.
constexpr double steps_per_distance = 200.0;
constexpr double least_spacing_m = 250.0;
constexpr double most_spacing_m = 5000.0;

constexpr double most_steps_of_room = 150.0;  // steps on each side: 100,000 vertices for a short route

double length_m(geo::PlanePoint step) { return std::hypot(step.x_m, step.y_m); }

std::vector<geo::LonLat> stops_of(const PlanRequest& request) {
  std::vector<geo::LonLat> stops{request.from};
  stops.insert(stops.end(), request.via.begin(), request.via.end());
  stops.push_back(request.to);
  return stops;
}

}  // namespace

plane::PlaneBox Layout::bounds() const {
  plane::PlaneBox box = grids.front().bounds();
  for (const RouteGrid& grid : grids) {
    box.include(grid.bounds().low);
    box.include(grid.bounds().high);
  }
  return box;
}

double Layout::most_vertices() const {
  double most = 0.0;
  for (const RouteGrid& grid : grids) most = std::max(most, grid.vertex_count());
  return most;
}

core::Metres Layout::map_cell() const {
  double finest_step_m = INFINITY;
  for (const RouteGrid& grid : grids) {
    finest_step_m = std::min({finest_step_m, length_m(grid.along), length_m(grid.across)});
  }
  const plane::PlaneBox area = bounds();
  const double by_memory = std::sqrt(area.width_m() * area.height_m() / most_map_cells);
  return core::Metres{std::max(finest_step_m / map_cells_per_step, by_memory)};
}

plane::PlaneBox Layout::area() const { return bounds().grown(2.0 * map_cell().value); }

geo::LonLat middle_of_stops(const PlanRequest& request) {
  const std::vector<geo::LonLat> stops = stops_of(request);
  const geo::BoundingBox box = geo::bounding_box(std::span{stops});
  return {geo::wrap_longitude(box.west_deg + 0.5 * geo::width_deg(box)),
          0.5 * (box.south_deg + box.north_deg)};
}

Layout lay_out(const PlanRequest& request, GridReach reach) {
  return lay_out(request, reach, geo::LocalProjection{middle_of_stops(request)});
}

Layout lay_out(const PlanRequest& request, GridReach reach, const geo::LocalProjection& projection) {
  Layout layout{.projection = projection, .stops = stops_of(request), .points = {}, .grids = {}};
  for (const geo::LonLat stop : layout.stops) layout.points.push_back(projection.to_plane(stop));
  for (std::size_t i = 1; i < layout.points.size(); ++i) {
    const geo::PlanePoint from = layout.points[i - 1];
    const geo::PlanePoint to = layout.points[i];
    const core::Metres distance{geo::distance_m(from, to)};
    layout.grids.push_back(lay_grid(from, to, spacing_for(request, distance), reach));
  }
  return layout;
}

std::vector<GridReach> reaches(const PlanRequest& request) {
  if (!request.room) return {first_reach, second_reach};
  return {GridReach{second_reach.across, second_reach.beyond, *request.room}};
}

GridSpacing spacing_for(const PlanRequest& request, core::Metres distance) {
  const core::Metres standard{
      std::clamp(distance.value / steps_per_distance, least_spacing_m, most_spacing_m)};
  const core::Metres along = request.spacing_along.value_or(standard);
  const core::Metres across = request.spacing_across.value_or(along);
  const core::Metres least = (1.0 / most_steps_of_room) * request.room.value_or(core::Metres{0.0});
  return {std::max(along, least), std::max(across, least)};
}

geo::BoundingBox planning_area(const PlanRequest& request) {
  const Layout layout = lay_out(request, reaches(request).back());
  return plane::lon_lat_box(layout.bounds(), layout.projection);
}

PlanRequest on_coarser_grids(const PlanRequest& request) {
  // Limit of the step, as a multiple of the usual one. In a test across 75 km of ice with 8 to 40 leads and a
  // limit on the time without surfacing, routes on steps of 1000 m instead of 400 m arrived 1 to 6 % earlier.
  constexpr double coarser = 2.5;
  const Layout layout = lay_out(request, first_reach);
  double way_m = 0.0;
  for (std::size_t i = 1; i < layout.points.size(); ++i)
    way_m += geo::distance_m(layout.points[i - 1], layout.points[i]);
  const core::Metres mean_leg{way_m / static_cast<double>(layout.grids.size())};
  PlanRequest coarse = request;
  coarse.spacing_along = coarser * spacing_for(request, mean_leg).along;
  return coarse;
}

}  // namespace floeplan::planning::cost

#include "engine/planning/plan_route.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "engine/geo/geodesic.hpp"
#include "engine/planning/explanation.hpp"
#include "engine/planning/plan_assembly.hpp"
#include "engine/planning/route_cost.hpp"
#include "engine/planning/route_grid.hpp"
#include "engine/planning/route_search.hpp"
#include "engine/planning/sea.hpp"
#include "engine/planning/straightening.hpp"

namespace floeplan::planning {
namespace {

constexpr GridReach first_reach{0.5, 0.25};
constexpr GridReach second_reach{1.0,
                                 0.75};  // tried when the first leaves no way, or the way runs along its rim
constexpr double most_vertices = 2.5e7;  // about 1 GB with the queue and the maps
constexpr double most_map_cells = 6.4e7;
constexpr double map_cells_per_step =
    3.0;  // of the safety map, so that passages of about a grid step stay open

// Spacing when the request gives none: command-line contract.
constexpr double steps_per_distance = 200.0;
constexpr double least_spacing_m = 250.0;
constexpr double most_spacing_m = 5000.0;

std::vector<geo::LonLat> stops_of(const PlanRequest& request) {
  std::vector<geo::LonLat> stops{request.from};
  stops.insert(stops.end(), request.via.begin(), request.via.end());
  stops.push_back(request.to);
  return stops;
}

geo::LonLat centre_of(const std::vector<geo::LonLat>& places) {
  const geo::BoundingBox box = geo::bounding_box(std::span{places});
  return {geo::wrap_longitude(box.west_deg + 0.5 * geo::width_deg(box)),
          0.5 * (box.south_deg + box.north_deg)};
}

GridSpacing spacing_for(const PlanRequest& request, double distance_m) {
  const core::Metres standard{std::clamp(distance_m / steps_per_distance, least_spacing_m, most_spacing_m)};
  const core::Metres along = request.spacing_along.value_or(standard);
  return {along, request.spacing_across.value_or(along)};
}

std::vector<RouteGrid> lay_grids(const std::vector<geo::PlanePoint>& stops, const PlanRequest& request,
                                 GridReach reach) {
  std::vector<RouteGrid> grids;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    const double distance_m = std::hypot(stops[i].x_m - stops[i - 1].x_m, stops[i].y_m - stops[i - 1].y_m);
    grids.push_back(lay_grid(stops[i - 1], stops[i], spacing_for(request, distance_m), reach));
  }
  return grids;
}

PlaneBox bounds_of(const std::vector<RouteGrid>& grids) {
  PlaneBox box = grids.front().bounds();
  for (const RouteGrid& grid : grids) {
    box.include(grid.bounds().low);
    box.include(grid.bounds().high);
  }
  return box;
}

core::Metres map_cell(const PlaneBox& area, double finest_step_m) {
  const double by_memory = std::sqrt(area.width_m() * area.height_m() / most_map_cells);
  return core::Metres{std::max(finest_step_m / map_cells_per_step, by_memory)};
}

/// Why a stop cannot be used; opens the map around each one that can.
std::optional<Infeasible> check_stops(Sea& sea, const std::vector<geo::LonLat>& stops,
                                      const PlanRequest& request) {
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const geo::PlanePoint point = sea.projection().to_plane(stops[i]);
    const Stop kind = i == 0 ? Stop::start : i + 1 == stops.size() ? Stop::goal : Stop::via;
    if (const auto closed = sea.safety().closed_at(stops[i]))
      return explain_place(*closed, kind, stops[i], request);
    if (sea.icebergs().contains(point)) {
      return explain_place(motion::EdgeClosed::obstacle, kind, stops[i], request);
    }
    sea.safety().open_around(point);
  }
  return std::nullopt;
}

/// Whether the path keeps to the rim of its grid, beyond which a better way may lie.
bool touches_rim(const std::vector<geo::PlanePoint>& path, const RouteGrid& grid) {
  const double along2 = grid.along.x_m * grid.along.x_m + grid.along.y_m * grid.along.y_m;
  const double across2 = grid.across.x_m * grid.across.x_m + grid.across.y_m * grid.across.y_m;
  return std::ranges::any_of(path, [&](geo::PlanePoint p) {
    const double dx = p.x_m - grid.origin.x_m;
    const double dy = p.y_m - grid.origin.y_m;
    const double column = (dx * grid.along.x_m + dy * grid.along.y_m) / along2;
    const double row = (dx * grid.across.x_m + dy * grid.across.y_m) / across2;
    return column < 0.5 || column > grid.nx - 1.5 || row < 0.5 || row > grid.ny - 1.5;
  });
}

void add(SearchStatistics& sum, const SearchStatistics& part) {
  sum.vertices += part.vertices;
  sum.edges += part.edges;
  sum.edge_evaluations += part.edge_evaluations;
  sum.expansions += part.expansions;
  sum.reinsertions += part.reinsertions;
}

struct Found {
  Route route;
  SearchStatistics statistics;
  bool touches_rim{false};
};

/// Searches stop after stop; under FIFO the earliest arrival at each stop is the best departure from it.
Result<Found> search_all(const Sea& sea, const std::vector<RouteGrid>& grids, const PlanRequest& request,
                         const std::stop_token& stop, const std::function<void(double)>& report) {
  Found found;
  found.route.points.push_back(grids.front().point(grids.front().start));
  found.route.fixed.push_back(true);
  core::Seconds depart{0.0};
  for (std::size_t i = 0; i < grids.size(); ++i) {
    const RouteSearch search = search_route(sea, grids[i], request, depart, stop, [&](double fraction) {
      report((static_cast<double>(i) + fraction) / static_cast<double>(grids.size()));
    });
    add(found.statistics, search.statistics);
    if (search.cancelled) return tl::unexpected(explain_cancelled(request));
    if (search.path.empty()) return tl::unexpected(explain_search(search, sea, request));

    const auto arrivals = arrivals_along(sea, search.path, depart);
    if (!arrivals) return tl::unexpected(explain_route(arrivals.error(), sea, request));
    depart = arrivals->back();
    found.touches_rim = found.touches_rim || touches_rim(search.path, grids[i]);
    for (std::size_t p = 1; p < search.path.size(); ++p) {
      found.route.points.push_back(search.path[p]);
      found.route.fixed.push_back(p + 1 == search.path.size());
    }
  }
  return found;
}

Route straight_route(const geo::LocalProjection& projection, const std::vector<geo::LonLat>& stops) {
  Route route;
  for (const geo::LonLat stop : stops) {
    route.points.push_back(projection.to_plane(stop));
    route.fixed.push_back(true);
  }
  return route;
}

/// Plans on grids of one reach.
Result<Plan> plan_within(GridReach reach, const ocean::Environment& environment, const PlanRequest& request,
                         const std::stop_token& stop, const core::ProgressCallback& progress,
                         bool& touches_rim) {
  const std::vector<geo::LonLat> stops = stops_of(request);
  const geo::LocalProjection projection{centre_of(stops)};
  const Route straight = straight_route(projection, stops);
  const std::vector<RouteGrid> grids = lay_grids(straight.points, request, reach);
  double vertices = 0.0;
  double finest_step_m = INFINITY;
  for (const RouteGrid& grid : grids) {
    vertices = std::max(vertices, grid.vertex_count());
    finest_step_m = std::min({finest_step_m, std::hypot(grid.along.x_m, grid.along.y_m),
                              std::hypot(grid.across.x_m, grid.across.y_m)});
  }
  if (request.method != Method::direct && vertices > most_vertices) {
    return tl::unexpected(explain_too_large(vertices, request));
  }

  progress("environment", 0.0);
  const PlaneBox bounds = bounds_of(grids);
  const core::Metres cell = map_cell(bounds, finest_step_m);
  Sea sea{environment, request, projection, bounds.grown(2.0 * cell.value), cell, stop};
  if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
  if (auto unusable = check_stops(sea, stops, request)) return tl::unexpected(std::move(*unusable));

  Found found{.route = straight, .statistics = {}, .touches_rim = false};
  if (request.method != Method::direct) {
    auto searched = search_all(sea, grids, request, stop,
                               [&](double fraction) { progress("search", 0.1 + 0.8 * fraction); });
    if (!searched) {
      touches_rim = true;
      return tl::unexpected(std::move(searched.error()));
    }
    found = std::move(*searched);
    found.route = join_collinear(found.route);
    progress("refinement", 0.9);
    if (request.refine) found.route = drop_needless_points(sea, found.route, core::Seconds{0.0}, stop);
    if (stop.stop_requested()) return tl::unexpected(explain_cancelled(request));
  }
  touches_rim = found.touches_rim;
  if (request.max_waypoints) {
    found.route =
        drop_to(sea, found.route, core::Seconds{0.0}, static_cast<std::size_t>(*request.max_waypoints));
  }

  const auto arrivals = arrivals_along(sea, found.route.points, core::Seconds{0.0});
  if (!arrivals) return tl::unexpected(explain_route(arrivals.error(), sea, request));
  Plan plan = assemble_plan(sea, environment, request, found.route.points, *arrivals);
  plan.search = found.statistics;
  if (request.max_waypoints && plan.waypoints.size() > static_cast<std::size_t>(*request.max_waypoints)) {
    plan.warnings.push_back("the route needs more waypoints than asked for; without them it would be closed");
  }
  progress("done", 1.0);
  return plan;
}

void refuse_invalid(const PlanRequest& request) {
  const core::Violations violations = request.violations();
  if (!violations.empty())
    throw std::invalid_argument{violations.front().field + ' ' + violations.front().rule};
}

}  // namespace

geo::BoundingBox planning_area(const PlanRequest& request) {
  const std::vector<geo::LonLat> stops = stops_of(request);
  const geo::LocalProjection projection{centre_of(stops)};
  const PlaneBox box = bounds_of(lay_grids(straight_route(projection, stops).points, request, second_reach));
  std::vector<geo::LonLat> rim;
  constexpr int samples = 32;
  for (int i = 0; i <= samples; ++i) {
    const double x = box.low.x_m + box.width_m() * i / samples;
    const double y = box.low.y_m + box.height_m() * i / samples;
    for (const geo::PlanePoint point : {geo::PlanePoint{x, box.low.y_m}, geo::PlanePoint{x, box.high.y_m},
                                        geo::PlanePoint{box.low.x_m, y}, geo::PlanePoint{box.high.x_m, y}}) {
      rim.push_back(projection.to_lon_lat(point));
    }
  }
  geo::BoundingBox area = geo::bounding_box(std::span<const geo::LonLat>{rim});
  for (const double pole_deg : {90.0, -90.0}) {
    const bool same_side = pole_deg * projection.origin().lat_deg > 0.0;
    if (same_side && box.contains(projection.to_plane({0.0, pole_deg}))) {
      (pole_deg > 0.0 ? area.north_deg : area.south_deg) = pole_deg;
      area.west_deg = -180.0;
      area.east_deg = 180.0;
    }
  }
  return area;
}

Result<Plan> plan_route(const ocean::Environment& environment, const PlanRequest& request,
                        const std::stop_token& stop, const core::ProgressCallback& report) {
  refuse_invalid(request);
  const core::ProgressCallback progress = report ? report : [](std::string_view, double) {};
  bool touches_rim = false;
  Result<Plan> first = plan_within(first_reach, environment, request, stop, progress, touches_rim);
  const bool cancelled = !first && first.error().reason == Reason::cancelled;
  if (!touches_rim || cancelled) return first;

  Result<Plan> second = plan_within(second_reach, environment, request, stop, progress, touches_rim);
  if (first && (!second || first->arrival <= second->arrival)) return first;
  return second;
}

Result<Plan> evaluate_route(const ocean::Environment& environment, const std::vector<geo::LonLat>& route,
                            const PlanRequest& request) {
  if (route.size() < 2) throw std::invalid_argument{"a route has at least two places"};
  PlanRequest on_route = request;
  on_route.from = route.front();
  on_route.to = route.back();
  on_route.via.assign(route.begin() + 1, route.end() - 1);
  on_route.method = Method::direct;
  on_route.max_waypoints.reset();
  if (!on_route.spacing_along) {
    // The safety map gets the step that a plan from end to end would have, not one for each short leg.
    double length_m = 0.0;
    for (std::size_t i = 1; i < route.size(); ++i)
      length_m += geo::geodesic_between(route[i - 1], route[i]).length.value;
    on_route.spacing_along = spacing_for(request, length_m).along;
  }
  bool touches_rim = false;
  refuse_invalid(on_route);
  return plan_within(first_reach, environment, on_route, {}, [](std::string_view, double) {}, touches_rim);
}

}  // namespace floeplan::planning

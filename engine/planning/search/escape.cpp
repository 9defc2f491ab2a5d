#include "engine/planning/search/escape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/geo/geodesic.hpp"
#include "engine/graph/nearest_goal_search.hpp"
#include "engine/planning/cost/straightening.hpp"
#include "engine/planning/search/explanation.hpp"

namespace floeplan::planning::search {
namespace {

constexpr int most_steps = 200;  // of the grid on each side, so that a search takes some tenths of a second

/// A grid around a point, with the spacing of another grid. A grid needs a goal, so the point is both start
/// and goal.
cost::RouteGrid grid_around(geo::PlanePoint point, const cost::RouteGrid& steps) {
  cost::RouteGrid grid = steps;
  grid.nx = 2 * most_steps + 1;
  grid.ny = grid.nx;
  grid.origin = {point.x_m - most_steps * (steps.along.x_m + steps.across.x_m),
                 point.y_m - most_steps * (steps.along.y_m + steps.across.y_m)};
  grid.start = static_cast<graph::Vertex>(most_steps * grid.nx + most_steps);
  grid.goal = grid.start;
  return grid;
}

/// Points of a route, the times there, and the propulsion to each point after the first.
struct TimedWay {
  std::vector<geo::PlanePoint> points;
  std::vector<core::Seconds> arrivals;
  std::vector<vehicle::Drive> drives{};

  void go_on(geo::PlanePoint point, core::Seconds arrival, vehicle::Drive drive) {
    points.push_back(point);
    arrivals.push_back(arrival);
    drives.push_back(drive);
  }
};

EscapeWay describe(const cost::Sea& sea, const TimedWay& timed) {
  const auto& [points, arrivals, drives] = timed;
  EscapeWay escape;
  escape.time = arrivals.back() - arrivals.front();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const EnergyUse use = sea.energy_along(points[i - 1], points[i], arrivals[i - 1],
                                           arrivals[i] - arrivals[i - 1], drives[i - 1]);
    escape.energy = escape.energy + use.total();
  }
  cost::Route route{points, std::vector<bool>(points.size(), false)};
  for (std::size_t i = 1; i < drives.size(); ++i) route.fixed[i] = drives[i] != drives[i - 1];
  std::size_t original = 0;
  for (const geo::PlanePoint point : cost::join_collinear(route).points) {
    while (points[original].x_m != point.x_m || points[original].y_m != point.y_m) ++original;
    escape.way.push_back(sea.domain().projection().to_lon_lat(point));
    if (original < drives.size()) escape.drives.push_back(drives[original]);
    ++original;
  }
  for (std::size_t i = 1; i < escape.way.size(); ++i) {
    const geo::GeodesicLine leg = geo::geodesic_between(escape.way[i - 1], escape.way[i]);
    if (i == 1) escape.course_deg = leg.course_at_start.degrees();
    escape.distance = escape.distance + leg.length;
  }
  return escape;
}

/// The part of the route from one of its points to the first place where the vehicle may surface, by `latest`. Empty
/// if there is none, or if the vehicle holds before it.
std::optional<TimedWay> way_onwards(const cost::Sea& sea, const std::vector<geo::PlanePoint>& route,
                                    const std::vector<core::Seconds>& arrivals,
                                    const std::vector<vehicle::Drive>& drives, std::size_t from,
                                    core::Seconds latest) {
  constexpr core::Seconds rounding{1.0};  // difference between timing a leg whole and in pieces
  TimedWay way{{route[from]}, {arrivals[from]}};
  for (std::size_t i = from; i + 1 < route.size(); ++i) {
    const auto time = sea.leg_time(route[i], route[i + 1], arrivals[i], core::Seconds{INFINITY}, drives[i]);
    if (!time || arrivals[i] + *time + rounding < arrivals[i + 1]) return std::nullopt;
    for (const cost::Sea::Passage& passage :
         sea.passages(route[i], route[i + 1], arrivals[i], sea.domain().overhead().look(), drives[i])) {
      if (passage.time > latest) return std::nullopt;
      if (!sea.domain().overhead().may_surface(passage.point, passage.time)) continue;
      way.go_on(passage.point, passage.time, drives[i]);
      return way;
    }
    way.go_on(route[i + 1], arrivals[i + 1], drives[i]);
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<EscapeWay>> plan_escapes(const cost::Sea& sea, const cost::Layout& layout,
                                            const PlanRequest& request,
                                            const std::vector<geo::PlanePoint>& route,
                                            const std::vector<core::Seconds>& arrivals,
                                            const std::vector<vehicle::Drive>& drives,
                                            const std::vector<SurfacingState>& waypoints,
                                            const std::stop_token& stop) {
  std::vector<EscapeWay> escapes;
  const auto bound = request.under_ice.max_time_without_surfacing;
  for (std::size_t i = 0; i < route.size(); ++i) {
    if (waypoints[i].may_surface) {
      escapes.push_back(describe(sea, {{route[i]}, {arrivals[i]}}));
      continue;
    }
    const core::Seconds depart = arrivals[i];
    const core::Seconds latest =
        bound ? depart + (*bound - waypoints[i].since_surfacing) : core::Seconds{INFINITY};
    const cost::RouteGrid grid = grid_around(route[i], layout.grids.front());
    const graph::GridGraph graph{grid.nx, grid.ny, request.sectors};
    const auto travel_time = [&](const graph::Edge& edge, core::Seconds from, core::Seconds until) {
      return sea.leg_time(grid.point(edge.tail), grid.point(edge.head), from, until);
    };
    const auto open = [&](graph::Vertex v, core::Seconds then) {
      return sea.domain().overhead().may_surface(grid.point(v), then);
    };

    const auto found = graph::find_nearest_goal(graph, grid.start, depart, latest, travel_time, open, stop);
    if (found.tree.stopped) return tl::unexpected(explain_cancelled(request));
    std::optional<TimedWay> way = way_onwards(sea, route, arrivals, drives, i, latest);
    if (found.goal && (!way || found.tree.arrival_s(*found.goal) < way->arrivals.back().count())) {
      way = TimedWay{{route[i]}, {depart}};
      for (const graph::Vertex v : graph::path_to(graph, found.tree, *found.goal))
        if (v != grid.start)
          way->go_on(grid.point(v), core::Seconds{found.tree.arrival_s(v)}, sea.drives().front());
    }
    if (!way) return tl::unexpected(explain_no_escape(sea, request, route[i], depart));
    escapes.push_back(describe(sea, *way));
  }
  return escapes;
}

}  // namespace floeplan::planning::search

#include "engine/planning/planner/large_obstacles.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/geometries.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "engine/planning/problem/time_span.hpp"

namespace floeplan::planning::planner {
namespace {

/// Closed cells this many steps apart, along each axis, belong to one obstacle: up to three open cells may
/// lie between them. A judgement.
constexpr std::int64_t longest_step = 4;

/// A place of a route.
struct RoutePlace {
  geo::PlanePoint point;
  core::Seconds time;
  std::size_t leg{};  // index of the leg's first point
  double distance_m{std::numeric_limits<double>::infinity()};
};

RoutePlace nearest_on(const TimedRoute& route, geo::PlanePoint place) {
  RoutePlace best;
  for (std::size_t i = 0; i + 1 < route.points.size(); ++i) {
    const geo::PlanePoint a = route.points[i];
    const geo::PlanePoint b = route.points[i + 1];
    const double dx = b.x_m - a.x_m;
    const double dy = b.y_m - a.y_m;
    const double along = ((place.x_m - a.x_m) * dx + (place.y_m - a.y_m) * dy) / (dx * dx + dy * dy);
    const double share = std::clamp(along, 0.0, 1.0);
    const geo::PlanePoint point{a.x_m + share * dx, a.y_m + share * dy};
    const double distance_m = geo::distance_m(place, point);
    if (distance_m < best.distance_m)
      best = {point, route.times[i] + share * (route.times[i + 1] - route.times[i]), i, distance_m};
  }
  return best;
}

bool any_holds(const std::vector<TimeSpan>& spans, core::Seconds time) {
  return std::ranges::any_of(spans,
                             [&](const TimeSpan& span) { return span.from <= time && time <= span.until; });
}

std::vector<geo::PlanePoint> convex_hull(const std::vector<geo::PlanePoint>& points) {
  using Point = boost::geometry::model::d2::point_xy<double>;
  boost::geometry::model::multi_point<Point> all;
  all.reserve(points.size());
  for (const geo::PlanePoint& point : points) all.emplace_back(point.x_m, point.y_m);
  constexpr bool clockwise = false;
  constexpr bool closed = false;
  boost::geometry::model::ring<Point, clockwise, closed> hull;
  boost::geometry::convex_hull(all, hull);
  std::vector<geo::PlanePoint> result;
  result.reserve(hull.size());
  for (const Point& point : hull) result.push_back({point.x(), point.y()});
  return result;
}

}  // namespace

geo::PlanePoint nearest_point(const TimedRoute& route, geo::PlanePoint place) {
  return nearest_on(route, place).point;
}

ObstacleScan::ObstacleScan(const obstacles::Closures& closures, const plane::PlaneBox& area,
                           core::Metres cell, const TimedRoute& route)
    : closures_{closures},
      route_{route},
      raster_{area, cell},
      cells_(raster_.size()),
      on_route_(raster_.size(), false) {
  for (std::size_t i = 0; i < cells_.size(); ++i) cells_[i] = look_at(raster_.centre(i));
  for (std::size_t i = 0; i + 1 < route.points.size(); ++i) {
    raster_.for_each_cell(route.points[i], route.points[i + 1], [&](std::int64_t ix, std::int64_t iy) {
      if (raster_.holds(ix, iy)) on_route_[raster_.index(ix, iy)] = true;
      return true;
    });
  }
}

std::optional<ObstacleKind> ObstacleScan::look_at(geo::PlanePoint point) const {
  using motion::EdgeClosed;
  if (const auto closed = closures_.closed_between(point, point)) {
    switch (*closed) {
      case EdgeClosed::on_land: return ObstacleKind::land;
      case EdgeClosed::obstacle: return ObstacleKind::icebergs;
      case EdgeClosed::in_zone: return ObstacleKind::closed_area;
      case EdgeClosed::outside_data: return ObstacleKind::no_data;
      default: return ObstacleKind::shallow_water;
    }
  }
  if (!closures_.any_timed()) return std::nullopt;
  const core::Seconds then = nearest_on(route_, point).time;
  if (any_holds(closures_.closed_times_by_icebergs(point), then)) return ObstacleKind::icebergs;
  if (any_holds(closures_.closed_times_by_zones(point), then)) return ObstacleKind::closed_area;
  return std::nullopt;
}

bool ObstacleScan::parted_by_route(std::size_t a, std::size_t b) const {
  bool parted = false;
  raster_.for_each_cell(raster_.centre(a), raster_.centre(b), [&](std::int64_t ix, std::int64_t iy) {
    parted = on_route_[raster_.index(ix, iy)];
    return !parted;
  });
  return parted;
}

std::vector<std::size_t> ObstacleScan::joined_to(std::size_t first, std::int64_t reach,
                                                 std::vector<bool>& seen) const {
  std::vector<std::size_t> cells{first};
  seen[first] = true;
  for (std::size_t next = 0; next < cells.size(); ++next) {
    const auto x = static_cast<std::int64_t>(cells[next]) % raster_.nx();
    const auto y = static_cast<std::int64_t>(cells[next]) / raster_.nx();
    for (std::int64_t iy = y - reach; iy <= y + reach; ++iy) {
      for (std::int64_t ix = x - reach; ix <= x + reach; ++ix) {
        if (!raster_.holds(ix, iy)) continue;
        const std::size_t cell = raster_.index(ix, iy);
        if (seen[cell] || !cells_[cell] || parted_by_route(cells[next], cell)) continue;
        seen[cell] = true;
        cells.push_back(cell);
      }
    }
  }
  return cells;
}

LargeObstacle ObstacleScan::obstacle_of(const std::vector<std::size_t>& cells) const {
  LargeObstacle result;
  std::vector<geo::PlanePoint> corners;
  corners.reserve(4 * cells.size());
  std::map<ObstacleKind, std::size_t> count;  // number of cells of each kind
  const double half_m = 0.5 * raster_.cell_m();
  plane::PlaneBox box{raster_.centre(cells.front()), raster_.centre(cells.front())};
  double nearest_m = std::numeric_limits<double>::infinity();
  double farthest_m = -1.0;
  for (const std::size_t cell : cells) {
    const geo::PlanePoint middle = raster_.centre(cell);
    for (const double x_m : {middle.x_m - half_m, middle.x_m + half_m})
      for (const double y_m : {middle.y_m - half_m, middle.y_m + half_m}) corners.push_back({x_m, y_m});
    ++count[*cells_[cell]];
    box.include(middle);
    const double away_m = nearest_on(route_, middle).distance_m;
    if (away_m < nearest_m) {
      nearest_m = away_m;
      result.nearest = middle;
    }
    if (away_m > farthest_m) {
      farthest_m = away_m;
      result.farthest = middle;
    }
  }
  result.kind = std::ranges::max_element(count, {}, [](const auto& each) { return each.second; })->first;
  result.outline = convex_hull(corners);
  const plane::PlaneBox whole = box.grown(half_m);
  result.middle = {0.5 * (whole.low.x_m + whole.high.x_m), 0.5 * (whole.low.y_m + whole.high.y_m)};
  result.extent = core::Metres{std::max(whole.width_m(), whole.height_m())};
  result.from_route = core::Metres{nearest_m};
  std::vector<bool> in_first_part(cells_.size(), false);
  const bool is_in_one_part = joined_to(cells.front(), 1, in_first_part).size() == cells.size();
  result.is_loose = !is_in_one_part || count.contains(ObstacleKind::icebergs);
  return result;
}

std::vector<LargeObstacle> ObstacleScan::of_at_least(core::Metres extent) const {
  std::vector<LargeObstacle> result;
  std::vector<bool> seen(cells_.size(), false);
  const auto is_at_rim = [&](std::size_t cell) {
    const auto x = static_cast<std::int64_t>(cell) % raster_.nx();
    const auto y = static_cast<std::int64_t>(cell) / raster_.nx();
    return x == 0 || y == 0 || x == raster_.nx() - 1 || y == raster_.ny() - 1;
  };
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    if (seen[cell] || !cells_[cell]) continue;
    const std::vector<std::size_t> cells = joined_to(cell, longest_step, seen);
    if (std::ranges::any_of(cells, is_at_rim)) continue;
    LargeObstacle obstacle = obstacle_of(cells);
    if (obstacle.extent >= extent) result.push_back(std::move(obstacle));
  }
  return result;
}

geo::PlanePoint ObstacleScan::beyond_route(const LargeObstacle& obstacle) const {
  const RoutePlace place = nearest_on(route_, obstacle.nearest);
  const geo::PlanePoint from = route_.points[place.leg];
  const geo::PlanePoint to = route_.points[place.leg + 1];
  // At right angles to the leg, on the side away from the obstacle. The line from obstacle to route would be
  // uncertain where they are close.
  geo::PlanePoint away{from.y_m - to.y_m, to.x_m - from.x_m};
  const double towards = away.x_m * (obstacle.farthest.x_m - place.point.x_m) +
                         away.y_m * (obstacle.farthest.y_m - place.point.y_m);
  const double step_m = (towards > 0.0 ? -1.0 : 1.0) * raster_.cell_m() / std::hypot(away.x_m, away.y_m);
  geo::PlanePoint end = place.point;
  for (;;) {
    const geo::PlanePoint next{end.x_m + step_m * away.x_m, end.y_m + step_m * away.y_m};
    if (!raster_.area().contains(next)) return end;
    end = next;
    if (closures_.closed_between(end, end)) return end;
  }
}

}  // namespace floeplan::planning::planner

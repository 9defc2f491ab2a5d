#include "engine/planning/cost/route_grid.hpp"

#include <algorithm>
#include <cmath>

namespace floeplan::planning::cost {
namespace {

constexpr double fewest_steps =
    10.0;  // grid steps of room on each side, so that short routes can make detours too

int steps_of_room(double room_m, double step_m, core::Metres at_least) {
  const double least = std::min(at_least.value / step_m, GridReach::most_steps_of_least);
  return static_cast<int>(std::ceil(std::max({room_m / step_m, least, fewest_steps})));
}

}  // namespace

core::Metres RouteGrid::shortest_step() const {
  return {std::min(std::hypot(along.x_m, along.y_m), std::hypot(across.x_m, across.y_m))};
}

plane::PlaneBox RouteGrid::bounds() const {
  const auto last = static_cast<graph::Vertex>(nx) * static_cast<graph::Vertex>(ny) - 1;
  plane::PlaneBox box{point(0), point(0)};
  box.include(point(static_cast<graph::Vertex>(nx - 1)));
  box.include(point(last));
  box.include(point(last - static_cast<graph::Vertex>(nx - 1)));
  return box;
}

RouteGrid lay_grid(geo::PlanePoint start, geo::PlanePoint goal, GridSpacing spacing, GridReach reach) {
  const double dx = goal.x_m - start.x_m;
  const double dy = goal.y_m - start.y_m;
  const double distance = std::hypot(dx, dy);
  double columns_between = 0.0;
  double step_along = spacing.along.value;
  geo::PlanePoint along{step_along, 0.0};
  geo::PlanePoint across{0.0, spacing.across.value};
  if (distance > 0.0) {
    columns_between = std::max(1.0, std::round(distance / spacing.along.value));
    step_along = distance / columns_between;
    along = {dx / columns_between, dy / columns_between};
    across = {-dy / distance * spacing.across.value, dx / distance * spacing.across.value};
  }
  const int beyond = steps_of_room(reach.beyond * distance, step_along, reach.at_least);
  const int aside = steps_of_room(reach.across * distance, spacing.across.value, reach.at_least);

  RouteGrid grid;
  grid.origin = {start.x_m - beyond * along.x_m - aside * across.x_m,
                 start.y_m - beyond * along.y_m - aside * across.y_m};
  grid.along = along;
  grid.across = across;
  grid.nx = static_cast<int>(columns_between) + 2 * beyond + 1;
  grid.ny = 2 * aside + 1;
  grid.start = static_cast<graph::Vertex>(aside) * static_cast<graph::Vertex>(grid.nx) +
               static_cast<graph::Vertex>(beyond);
  grid.goal = grid.start + static_cast<graph::Vertex>(columns_between);
  return grid;
}

}  // namespace floeplan::planning::cost

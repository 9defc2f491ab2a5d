#include "engine/planning/plane/plane_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/planning/plane/node_window.hpp"

namespace floeplan::planning::plane {
namespace {

double narrowest_cell(const FastAxis& axis) {
  double narrowest = INFINITY;
  for (std::size_t i = 1; i < axis.size(); ++i)
    narrowest = std::min(narrowest, axis.nodes()[i] - axis.nodes()[i - 1]);
  return narrowest;
}

}  // namespace

PlaneGrid::PlaneGrid(const ocean::HorizontalGrid& grid, const geo::LocalProjection& projection,
                     const PlaneBox& area, const std::stop_token& stop)
    : lookup_{grid.frame(), projection, area, stop}, x_{{0.0}}, y_{{0.0}} {
  NodeWindow window = node_window(grid, lookup_, area);
  x_ = FastAxis{std::move(window.x)};
  y_ = FastAxis{std::move(window.y)};
  columns_ = std::move(window.columns);
  first_row_ = window.first_row;
}

std::optional<PlaneGrid::Corner> PlaneGrid::corner(geo::PlanePoint point) const {
  const geo::GridPoint at = lookup_.coordinates(point);
  const auto x = x_.locate(at.x);
  const auto y = y_.locate(at.y);
  if (!x || !y) return std::nullopt;
  return Corner{y->cell * x_.size() + x->cell, x->share, y->share};
}

std::optional<geo::GridPoint> PlaneGrid::place_among_nodes(geo::PlanePoint point) const {
  const auto cell = corner(point);
  if (!cell) return std::nullopt;
  return geo::GridPoint{static_cast<double>(cell->first % x_.size()) + cell->fx,
                        static_cast<double>(cell->first / x_.size()) + cell->fy};
}

double PlaneGrid::least_cell_m() const {
  if (lookup_.has_jump()) return 0.0;
  const geo::GridPoint steepest = lookup_.steepest();
  return std::min(narrowest_cell(x_) / steepest.x, narrowest_cell(y_) / steepest.y);
}

}  // namespace floeplan::planning::plane

#include "engine/planning/plane_grid.hpp"

#include <utility>

#include "engine/planning/node_window.hpp"

namespace floeplan::planning {
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

}  // namespace floeplan::planning

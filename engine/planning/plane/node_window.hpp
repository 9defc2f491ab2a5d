#pragma once

#include <cstddef>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/planning/plane/grid_lookup.hpp"
#include "engine/planning/plane/plane_box.hpp"

namespace floeplan::planning::plane {

/// The nodes of a data grid that a planning area needs.
struct NodeWindow {
  std::vector<double> x;  // grid coordinates; longitudes continuous, also across the data's seam
  std::vector<double> y;
  std::vector<std::size_t> columns;  // column in the data, for each of x
  std::size_t first_row{};           // row in the data, for the first of y

  [[nodiscard]] std::size_t size() const { return x.size() * y.size(); }
};

/// Never empty: for a grid that lies outside the area it has one column, in which no point is found.
[[nodiscard]] NodeWindow node_window(const ocean::HorizontalGrid& grid, const GridLookup& lookup,
                                     const PlaneBox& area);

}  // namespace floeplan::planning::plane

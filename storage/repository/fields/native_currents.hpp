#pragma once

#include <optional>
#include <stop_token>

#include "engine/geo/bounding_box.hpp"
#include "engine/ocean/currents/current_grid.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/repository/fields/grid_window.hpp"
#include "storage/repository/fields/point_reader.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Which currents at a model's own points are asked for, and where.
struct NativeRequest {
  geo::BoundingBox area;
  ocean::HorizontalGrid lattice;  // the dataset's lattice around the area
  std::optional<AxisWindow> depths;
  AxisWindow times;
};

/// Reads currents at a model's own points and interpolates them to the nodes of the lattice, which is refined
/// where the model is. An area without extent gives only that place, so that a point of the model gets the
/// model's own value. Levels that follow the sea bed are interpolated to the requested depths; at a single
/// place the depths of the levels there are added.
/// Stops  early once `stop` is requested; the result is then incomplete and must not be used
[[nodiscard]] ocean::CurrentGrid read_native_currents(sql::Connection& db, const NativeLayout& layout,
                                                      const NativeRequest& request,
                                                      const std::stop_token& stop);

}  // namespace floeplan::repository

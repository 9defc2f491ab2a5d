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
  ocean::HorizontalGrid lattice;  // of the dataset, about the area
  std::optional<AxisWindow> depths;
  AxisWindow times;
};

/// Currents at a model's own points, interpolated at the nodes of the lattice, which is refined where the model is; of an
/// area without extent at that place alone, so that a point of the model has the model's own value. Levels that follow
/// the sea bed are interpolated at the depths; at a single place these are joined by the depths of the levels there.
/// Stops  early once `stop` is requested; what is returned then is incomplete and must not be used
[[nodiscard]] ocean::CurrentGrid read_native_currents(sql::Connection& db, const NativeLayout& layout,
                                                      const NativeRequest& request,
                                                      const std::stop_token& stop);

}  // namespace floeplan::repository

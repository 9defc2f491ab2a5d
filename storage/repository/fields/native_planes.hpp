#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "engine/geo/lon_lat.hpp"
#include "engine/ocean/bed/bathymetry.hpp"
#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/ice/ice_field.hpp"
#include "storage/repository/fields/grid_window.hpp"
#include "storage/repository/fields/point_reader.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Depths at a model's own points, interpolated at the nodes of use (`nodes_of_use`). The least depth at a place is no more
/// than that of the shoalest corner of the cell in which it lies.
/// `lattice`       of the dataset, about the area
/// `has_shoalest`  whether the least depth round each point is stored beside its depth
[[nodiscard]] ocean::Bathymetry read_native_depths(sql::Connection& db, const NativeLayout& layout,
                                                   const geo::BoundingBox& area,
                                                   const ocean::HorizontalGrid& lattice, bool has_shoalest);

/// Sea ice at a model's own points, interpolated at the nodes of use.
/// `lattice`  of the dataset, about the area
/// Stops      early once `stop` is requested; what is returned then is incomplete and must not be used
[[nodiscard]] ocean::IceField read_native_ice(sql::Connection& db, const NativeLayout& layout,
                                              const geo::BoundingBox& area,
                                              const ocean::HorizontalGrid& lattice, const AxisWindow& times,
                                              bool has_thickness, const std::stop_token& stop);

/// A variable without depths at a place, one value for each of the steps; NaN outside the model's water.
[[nodiscard]] std::vector<float> read_native_series(sql::Connection& db, const NativeLayout& layout,
                                                    geo::LonLat place, const std::string& variable,
                                                    const AxisWindow& times);

}  // namespace floeplan::repository

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/grids/own_points.hpp"
#include "storage/ingest/grids/water_mask.hpp"

namespace floeplan::ingest {

/// A variable on a bent grid, whose places are two-dimensional tables.
struct BentPlane {
  NetcdfLayout layout;  // its points, [row][column]
  OwnPoints own;        // numbered as in `layout`
  WaterMask water;      // of ROMS, which has depths on land too
};

/// Returns  nullopt if the file has no tables of positions over the variable's horizontal dimensions
/// Errors   damaged tables; dimensions whose meaning is not known
[[nodiscard]] Checked<std::optional<BentPlane>> bent_plane_of(const std::shared_ptr<const NetcdfFile>& file,
                                                              const NetcdfVariable& variable);

/// A variable and the grid on which it is used: that of its own nodes, or one on which it is interpolated
/// when it is read.
struct PlacedVariable {
  NetcdfLayout layout;
  ocean::HorizontalGrid grid;
  std::optional<BentPlane> bent;  // empty: the layout's points are the grid's nodes
};

/// On its own axes where they are a grid of the store, else at the points of its tables of positions or its
/// projection.
/// `stated_crs`  the projection of a file that states none
/// Errors        as layout_of and grid_of
[[nodiscard]] Checked<PlacedVariable> place_of(const std::shared_ptr<const NetcdfFile>& file,
                                               const NetcdfVariable& variable,
                                               const std::optional<std::string>& stated_crs);

}  // namespace floeplan::ingest

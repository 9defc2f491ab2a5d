#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "engine/ocean/grids/mesh_sampling.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/formats/netcdf/netcdf_layout.hpp"
#include "storage/ingest/grids/raw_rows.hpp"
#include "storage/ingest/grids/water_mask.hpp"

namespace floeplan::ingest {

/// A variable on a bent grid, whose places are two-dimensional tables, and the regular grid on which it is stored.
struct BentPlane {
  NetcdfLayout layout;  // its points, [row][column]
  std::vector<geo::LonLat> points;
  ocean::HorizontalGrid grid;
  ocean::MeshSampling sampling;
  WaterMask water;            // of ROMS, which has depths on land too
  messages::Message account;  // that it was resampled
};

/// Returns  nullopt when the file holds no tables of positions over the variable's plane
/// Errors   damaged tables; dimensions whose meaning is not known
[[nodiscard]] Checked<std::optional<BentPlane>> bent_plane_of(const std::shared_ptr<const NetcdfFile>& file,
                                                              const NetcdfVariable& variable);

/// A variable and the grid on which it is stored: that of its own nodes, or one onto which it is resampled.
struct PlacedVariable {
  NetcdfLayout layout;
  ocean::HorizontalGrid grid;
  std::optional<BentPlane> bent;  // empty: the layout's points are the grid's nodes
};

/// On its own axes where they are a grid of the store, else resampled from its tables of positions or its projection.
/// `stated_crs`  the projection of a file that states none
/// Errors        as layout_of and grid_of
[[nodiscard]] Checked<PlacedVariable> place_of(const std::shared_ptr<const NetcdfFile>& file,
                                               const NetcdfVariable& variable,
                                               const std::optional<std::string>& stated_crs);

/// The values at the nodes and, around each, the lowest and the highest of its neighbouring points, also of those that
/// lie closer together than the nodes.
/// Shape  of the points in, of the grid [y][x] out
[[nodiscard]] RawRows resampled_with_range(const BentPlane& plane, std::span<const float> values);

}  // namespace floeplan::ingest

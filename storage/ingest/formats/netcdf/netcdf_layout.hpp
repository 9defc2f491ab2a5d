#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/repository/fields/field_repository.hpp"

namespace floeplan::ingest {

/// How a variable is arranged in space and time: the meaning of each of its dimensions, and the coordinates
/// along them.
struct NetcdfLayout {
  std::size_t x_dimension{};
  std::size_t y_dimension{};
  std::optional<std::size_t> depth_dimension;
  std::optional<std::size_t> time_dimension;
  AxisNodes x;  // degrees east, metres of the projection, or only indices
  AxisNodes y;
  bool projected{false};
  std::optional<AxisNodes> depths_m;  // positive down; also a scalar level, with one node and no dimension
  std::size_t bed_levels{};           // number of levels if they follow the sea bed; otherwise 0
  std::optional<AxisNodes> times_s;   // seconds since 1970-01-01T00:00:00Z; also a scalar time, with one node
  Messages warnings;
};

/// Finds the layout of a variable on a regular grid, in longitude and latitude or projected. Dimensions may
/// have any order.
/// Errors   curvilinear, staggered, terrain-following and unstructured grids are refused by name; so are
///          times that cannot be decoded and sizes that would not fit into memory
[[nodiscard]] Checked<NetcdfLayout> layout_of(const NetcdfFile& file, const NetcdfVariable& variable);

/// The layout of a variable whose positions are in tables; x and y are indices. The points of a mesh have one
/// dimension only, which is then both `y_dimension` and `x_dimension`. Levels may follow the sea bed.
/// Errors   as layout_of
[[nodiscard]] Checked<NetcdfLayout> layout_over(const NetcdfFile& file, const NetcdfVariable& variable,
                                                std::size_t y_dimension, std::size_t x_dimension);

/// Why a variable is not on a regular grid that this program reads; nullopt if no reason is found.
[[nodiscard]] std::optional<messages::Message> unsupported_grid(const NetcdfFile& file,
                                                                const NetcdfVariable& variable);

/// One horizontal slice [y][x] in the layout's ascending order, unpacked; indices count along the layout's
/// axes. NaN marks a missing sample.
[[nodiscard]] Checked<std::vector<double>> read_slice(const NetcdfVariable& variable,
                                                      const NetcdfLayout& layout, std::size_t time_index,
                                                      std::size_t depth_index);

/// Reads `rows` rows of a slice from `first_row` on, counted along the layout's y.
[[nodiscard]] Checked<std::vector<double>> read_rows(const NetcdfVariable& variable,
                                                     const NetcdfLayout& layout, std::size_t time_index,
                                                     std::size_t depth_index, std::size_t first_row,
                                                     std::size_t rows);

}  // namespace floeplan::ingest

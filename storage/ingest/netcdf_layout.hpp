#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/geo/bounding_box.hpp"
#include "storage/ingest/netcdf_axis.hpp"
#include "storage/repository/field_repository.hpp"

namespace floeplan::ingest {

/// How a variable lies on the Earth, in depth and in time: which of its dimensions is what, and the
/// coordinates along it.
struct NetcdfLayout {
  std::size_t x_dimension{};
  std::size_t y_dimension{};
  std::optional<std::size_t> depth_dimension;
  std::optional<std::size_t> time_dimension;
  AxisNodes x;  // degrees east, or the projection's own coordinate in metres
  AxisNodes y;
  bool projected{false};
  std::optional<AxisNodes> depths_m;  // positive down
  std::optional<AxisNodes> times_s;   // seconds since 1970-01-01T00:00:00Z; also a scalar time, with one node
  std::vector<std::string> warnings;
};

/// Finds the layout of a variable on a regular grid, longitude and latitude or projected, dimensions in any
/// order.
/// Errors   curvilinear, staggered, terrain-following and unstructured grids are refused by name; so are
///          times that cannot be decoded and sizes that would not fit into memory
[[nodiscard]] Checked<NetcdfLayout> layout_of(const NetcdfFile& file, const NetcdfVariable& variable);

/// Why the variable is not on a regular grid that this program reads; nullopt when nothing speaks against it.
[[nodiscard]] std::optional<std::string> unsupported_grid(const NetcdfFile& file,
                                                          const NetcdfVariable& variable);

/// One horizontal slice [y][x] in the layout's ascending order, unpacked; indices count along the layout's
/// axes. NaN marks a missing sample.
[[nodiscard]] Checked<std::vector<double>> read_slice(const NetcdfVariable& variable,
                                                      const NetcdfLayout& layout, std::size_t time_index,
                                                      std::size_t depth_index);

}  // namespace floeplan::ingest

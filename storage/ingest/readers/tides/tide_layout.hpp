#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "engine/ocean/grids/horizontal_grid.hpp"
#include "storage/ingest/formats/netcdf/netcdf_axis.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/readers/tides/tide_variables.hpp"

namespace floeplan::ingest {

/// Arrangement of a tide's field in its file: the meaning of each dimension, and the positions of the nodes.
struct TideLayout {
  std::size_t x_dimension{};
  std::size_t y_dimension{};
  std::optional<std::size_t> line_dimension;  // dimension of the constituents
  AxisNodes x;
  AxisNodes y;
  ocean::HorizontalGrid grid;
};

/// Finds the axes by their names for the quantity (lon_z, lon_u, lon_v); otherwise lon and lat, or x and y
/// with the projection that the file states. Rectangular tables of positions are read as axes.
/// Errors   no axes are found, or the grid is curvilinear
[[nodiscard]] Checked<TideLayout> tide_layout_of(const NetcdfFile& file, const TideVariables& tide,
                                                 const std::optional<std::string>& stated_crs);

/// The first part of a file's name that is a constituent: M2 in "h_m2_tpxo9_atlas_30_v4", 2N2 in
/// "2n2_fes2014c".
[[nodiscard]] std::optional<tide::Constituent> constituent_named_in(const std::string& file_stem);

/// The names of the constituents of a file, one for each index of their dimension: from the attribute
/// constituent_order, the variable con, or, for a single field, the first part of the file's name that is a
/// constituent.
/// Errors   none of these; a number of names that differs from `wanted`
[[nodiscard]] Checked<std::vector<std::string>> tide_names(const NetcdfFile& file,
                                                           const std::string& file_stem, std::size_t wanted);

/// One field [y][x] in ascending order, A exp(-i g) in the file's unit; NaN where a part is missing or both
/// are exactly zero, which is how models write land.
[[nodiscard]] Checked<std::vector<std::complex<double>>> read_tide_field(const TideVariables& tide,
                                                                         const TideLayout& layout,
                                                                         std::size_t line);

/// Depths of the water column at the layout's nodes, metres, NaN on land, from the first file that has depths
/// at these nodes; empty if none has.
[[nodiscard]] Checked<std::vector<double>> read_tide_depths(const NetcdfFiles& files,
                                                            const TideVariables& tide,
                                                            const TideLayout& layout,
                                                            const std::optional<std::string>& stated_crs);

}  // namespace floeplan::ingest

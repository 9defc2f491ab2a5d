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

/// How a field of a tide lies in its file: which dimension is what, and where its nodes are.
struct TideLayout {
  std::size_t x_dimension{};
  std::size_t y_dimension{};
  std::optional<std::size_t> line_dimension;  // of the constituents
  AxisNodes x;
  AxisNodes y;
  ocean::HorizontalGrid grid;
};

/// Finds the axes by their names for the quantity (lon_z, lon_u, lon_v), else lon and lat, or x and y with the
/// projection that the file states. Tables of positions are read as axes where they are rectangular.
/// Errors   axes that cannot be found, or a grid that is bent
[[nodiscard]] Checked<TideLayout> tide_layout_of(const NetcdfFile& file, const TideVariables& tide,
                                                 const std::optional<std::string>& stated_crs);

/// The first part of a file's name that is a constituent: "m2" of "h_m2_tpxo9_atlas_30_v4", "2n2_fes2014c".
[[nodiscard]] std::optional<tide::Constituent> constituent_named_in(const std::string& file_stem);

/// The names of the constituents of a file, one for each step of their dimension. Named by the attribute
/// constituent_order, by the variable con, or (for a single one) by the first part of the file's name that is one.
/// Errors   none of them; as many names as there are fields are needed
[[nodiscard]] Checked<std::vector<std::string>> tide_names(const NetcdfFile& file,
                                                           const std::string& file_stem, std::size_t wanted);

/// One field [y][x] in ascending order, A exp(-i g) in the file's unit; NaN where a part is missing or both are exactly
/// zero, as models write land.
[[nodiscard]] Checked<std::vector<std::complex<double>>> read_tide_field(const TideVariables& tide,
                                                                         const TideLayout& layout,
                                                                         std::size_t line);

/// The depths of the water column on the layout's own nodes, metres, NaN on land; from the first of the files that has
/// them there, empty when none does.
[[nodiscard]] Checked<std::vector<double>> read_tide_depths(const NetcdfFiles& files,
                                                            const TideVariables& tide,
                                                            const TideLayout& layout,
                                                            const std::optional<std::string>& stated_crs);

}  // namespace floeplan::ingest

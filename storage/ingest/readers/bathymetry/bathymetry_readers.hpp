#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// Bathymetry from a raster file: GeoTIFF, ESRI ASCII grid, XYZ or BAG (its elevation layer). Geographic,
/// polar stereographic and transverse Mercator grids keep their nodes; others are resampled to longitude and
/// latitude.
/// Edges    values stand for pixel centres; axis order is always easting or longitude first
/// Errors   pictures;
///          no CRS (plain text grids may be recognised as degrees, with a warning); rotated grids
[[nodiscard]] Checked<PreparedDataset> read_raster_bathymetry(const std::filesystem::path& file,
                                                              const char* driver,
                                                              const IngestOptions& options);

/// The same from a table with named columns, whose column also tells depth from elevation.
[[nodiscard]] Checked<PreparedDataset> read_depth_table(const std::filesystem::path& file,
                                                        const IngestOptions& options);

/// The variable that holds depths or elevations; null when none claims to. With `any_plane` a lone variable
/// over two dimensions is taken whatever its name.
[[nodiscard]] const NetcdfVariable* find_bathymetry(const NetcdfFile& file, bool any_plane);

/// Bathymetry from the coordinate variables of a NetCDF file (never from a mean grid step, which real axes do
/// not keep).
[[nodiscard]] Checked<PreparedDataset> read_netcdf_bathymetry(std::shared_ptr<const NetcdfFile> file,
                                                              const IngestOptions& options);

/// Checks that an ESRI ASCII grid holds as many values as its header announces. Needed because GDAL 3.6 waits
/// for ever for the values of a file that was cut short.
/// Returns  the number of values
/// Errors   no usable ncols and nrows; too few values
[[nodiscard]] Checked<std::uint64_t> ascii_grid_length(const std::filesystem::path& file);

/// Bathymetry from a cell of an electronic chart (S-57 ENC), with its updates, on a grid of half a millimetre at the
/// chart's scale: at each node the middle of its depth area, and beside it the least depth that anything charted in the
/// cell may have. Outside the cell's coverage and where the chart gives no depth area nothing is known.
/// Errors   as read_s57_cell; a coverage of more nodes than this program accepts
[[nodiscard]] Checked<PreparedDataset> read_s57_bathymetry(const std::filesystem::path& base);

/// Depths of IHO S-102, positive down, with the uncertainty of each: the bed may lie as much higher.
/// Errors   as s100_coverage; a unit that is no length
/// Source   IHO S-102 edition 3.0.0, tables 10-2 to 10-8
[[nodiscard]] Checked<PreparedDataset> read_s102_bathymetry(const std::filesystem::path& file);

}  // namespace floeplan::ingest

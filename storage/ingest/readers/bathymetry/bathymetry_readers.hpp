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
/// polar stereographic and transverse Mercator grids keep their nodes; the pixels of all others, and of rotated grids, are kept
/// at places of their own, at most two million of them.
/// Edges    values belong to pixel centres; easting or longitude always comes first
/// Errors   pictures; no CRS (a plain text grid may be recognised as degrees, with a warning); too many pixels
[[nodiscard]] Checked<PreparedDataset> read_raster_bathymetry(const std::filesystem::path& file,
                                                              const char* driver,
                                                              const IngestOptions& options);

/// Bathymetry from a table with named columns; the name of its column tells whether it holds depths or
/// elevations.
[[nodiscard]] Checked<PreparedDataset> read_depth_table(const std::filesystem::path& file,
                                                        const IngestOptions& options);

/// The variable that holds depths or elevations; null if none says so by its name or attributes. With
/// `any_plane` the only variable over two dimensions is accepted, whatever its name.
[[nodiscard]] const NetcdfVariable* find_bathymetry(const NetcdfFile& file, bool any_plane);

/// Bathymetry of a NetCDF file. The positions come from its coordinate variables, never from a mean grid
/// step, because real axes are not perfectly regular.
[[nodiscard]] Checked<PreparedDataset> read_netcdf_bathymetry(std::shared_ptr<const NetcdfFile> file,
                                                              const IngestOptions& options);

/// Checks that an ESRI ASCII grid has as many values as its header states. GDAL 3.6 would wait for ever for
/// the missing values of a file that was cut short.
/// Returns  the number of values
/// Errors   no usable ncols and nrows; too few values
[[nodiscard]] Checked<std::uint64_t> ascii_grid_length(const std::filesystem::path& file);

/// Bathymetry from a cell of an electronic chart (S-57 ENC) with its updates, on a grid of half a millimetre
/// at the chart's scale. Each node has the middle of its depth area's range, and the least depth of any
/// object in its cell. There is no value outside the chart's coverage, nor where the chart has no depth area.
/// Errors   those of read_s57_cell; a grid of more nodes than this program accepts
[[nodiscard]] Checked<PreparedDataset> read_s57_bathymetry(const std::filesystem::path& base);

/// Depths of an IHO S-102 file, positive down, with the uncertainty of each: the bed may lie higher by that
/// much.
/// Errors   those of s100_coverage; a unit that is not a length
/// Source   IHO S-102 edition 3.0.0, tables 10-2 to 10-8
[[nodiscard]] Checked<PreparedDataset> read_s102_bathymetry(const std::filesystem::path& file);

}  // namespace floeplan::ingest

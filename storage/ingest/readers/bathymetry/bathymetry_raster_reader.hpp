#pragma once

#include <filesystem>

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

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

}  // namespace floeplan::ingest

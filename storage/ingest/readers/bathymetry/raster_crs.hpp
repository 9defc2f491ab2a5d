#pragma once

#include <ogr_spatialref.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Stands for the name of a GDAL driver when the file is a table with named columns.
inline constexpr std::string_view depth_table = "depth table";

using RasterTransform = std::array<double, 6>;  // GDAL's affine geotransform

/// The horizontal reference system of a raster: the file's, or else the user's. For a plain text whose
/// numbers look like degrees it is longitude and latitude, with a warning. Easting or longitude is the first
/// axis.
/// Errors   none of these is known; a BAG with positive down, unless the user states the direction
[[nodiscard]] Checked<OGRSpatialReference> crs_of_raster(GDALDataset& dataset, std::string_view driver,
                                                         const IngestOptions& options, Messages& warnings);

}  // namespace floeplan::ingest

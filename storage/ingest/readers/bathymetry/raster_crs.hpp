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

/// In the place of a driver's name, of a table with named columns.
inline constexpr std::string_view depth_table = "depth table";

using RasterTransform = std::array<double, 6>;  // GDAL's affine geotransform

[[nodiscard]] std::string wkt_of(const OGRSpatialReference& crs);

/// The horizontal reference system of a raster: the one that the file states, else the user, else longitude and latitude
/// where a plain text's numbers look like them, which is said in `warnings`. Axes easting or longitude first.
/// Errors   none of these; a BAG that counts downwards, unless the user says which way
[[nodiscard]] Checked<OGRSpatialReference> crs_of_raster(GDALDataset& dataset, std::string_view driver,
                                                         const IngestOptions& options, Messages& warnings);

/// What to resample a raster to: longitude and latitude, or a polar plane for what lies round a pole or across the
/// antimeridian, where degrees have a seam and grow too narrow. Only of what lies in high latitudes, so that the plane
/// stays true.
[[nodiscard]] const char* target_crs_for(GDALDataset& dataset, const OGRSpatialReference& crs);

}  // namespace floeplan::ingest

#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Opens a file of features with one of GDAL's drivers, "GPKG" or "ESRI Shapefile".
/// Errors   damaged; a GeoPackage with views, computed columns or virtual tables but R*Trees; no features; a value that GDAL leaves out since it is none of its column's type
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_vector_file(const std::filesystem::path& file,
                                                                     const char* driver);

/// A shapefile and the files beside it that belong to it.
[[nodiscard]] std::vector<std::filesystem::path> parts_of_shapefile(const std::filesystem::path& file);

}  // namespace floeplan::ingest

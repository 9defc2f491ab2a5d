#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "storage/demo/raster_frame.hpp"

namespace floeplan::demo {

/// Writes heights (metres, positive up) as a GeoTIFF in EPSG:4326, float32, north up.
/// Errors   std::runtime_error when the file cannot be written
void write_bathymetry(const std::filesystem::path& file, const RasterFrame& frame,
                      const std::vector<float>& elevation_m, const std::string& description);

}  // namespace floeplan::demo

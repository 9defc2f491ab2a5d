#pragma once

#include <filesystem>
#include <string>

#include "storage/ingest/common/refusal.hpp"

namespace floeplan::ingest {

/// Formats that this program reads, told apart by the first bytes; a file's name plays no part.
enum class FileFormat {
  netcdf_classic,
  netcdf4,
  zarr,
  grib,
  bag,
  geotiff,
  ascii_grid,
  xyz,
  depth_table,
  ice_patrol_csv,
  geojson,
  iceberg_table,
  own_iceberg_table,
  iceberg_json,
  tide_json,
  tide_table,
  otps_extract,
  kml,
  geopackage,
  shapefile,
  s57,
  slocum_text,
  slocum_binary
};

/// `icebergs_stated`  the user says that the file holds icebergs: tables need no column of their own for them
/// Errors   every other file, by name where it is known (chart pictures, Zarr, archives, ...); an empty
/// file; a
///          folder; a classic NetCDF file that is shorter than its header says
[[nodiscard]] Checked<FileFormat> format_of(const std::filesystem::path& file, bool icebergs_stated = false);

}  // namespace floeplan::ingest

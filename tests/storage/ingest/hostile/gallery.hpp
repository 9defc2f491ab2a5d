#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace floeplan::ingest {

/// What the files of the gallery try to reach.
struct HostileAims {
  std::filesystem::path secret;  // a file that no reader may open
  std::filesystem::path store;   // a store in use
  std::uint16_t port{};          // of a listener on 127.0.0.1 that no reader may contact
};

/// A hostile file, or several that are given together.
struct HostileFile {
  std::string format;  // the format that it pretends to have
  std::string wants;   // what it tries, in words
  std::function<std::vector<std::filesystem::path>(const std::filesystem::path& folder)> write;
  std::optional<std::string> crs{};  // the reference system with which it is ingested
};

/// Every format that ingest distinguishes, archives, and formats that GDAL would read and this program does
/// not.
inline constexpr std::string_view hostile_formats[]{
    "NetCDF classic", "NetCDF-4",     "BAG",         "Zarr",        "GRIB",          "GeoTIFF",
    "ASCII grid",     "XYZ",          "depth table", "ice patrol",  "GeoJSON",       "iceberg table",
    "own table",      "iceberg list", "tide JSON",   "tide table",  "OTPS",          "KML",
    "GeoPackage",     "shapefile",    "S-57",        "Slocum text", "Slocum binary", "archive",
    "CRS text",       "foreign"};

/// All hostile files. Every call makes them anew, with places, sizes and aims that depend on the seed.
[[nodiscard]] std::vector<HostileFile> hostile_files(const HostileAims& aims, std::mt19937_64& rng);

}  // namespace floeplan::ingest

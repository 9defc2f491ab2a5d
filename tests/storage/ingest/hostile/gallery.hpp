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

/// What files of the gallery are after.
struct HostileAims {
  std::filesystem::path secret;  // a file that no reader may open
  std::filesystem::path store;   // a store in use
  std::uint16_t port{};          // of a listener on 127.0.0.1 that nobody may come to
};

/// A file that nobody means well with, or several that are given together.
struct HostileFile {
  std::string format;  // that it passes for
  std::string wants;   // in words
  std::function<std::vector<std::filesystem::path>(const std::filesystem::path& folder)> write;
  std::optional<std::string> crs{};  // which the user is told to give with it
};

/// Every format that ingest reads by a name of its own, archives, and what GDAL would read and this program does not.
inline constexpr std::string_view hostile_formats[]{
    "NetCDF classic", "NetCDF-4",     "BAG",         "Zarr",        "GRIB",          "GeoTIFF",
    "ASCII grid",     "XYZ",          "depth table", "ice patrol",  "GeoJSON",       "iceberg table",
    "own table",      "iceberg list", "tide JSON",   "tide table",  "OTPS",          "KML",
    "GeoPackage",     "shapefile",    "S-57",        "Slocum text", "Slocum binary", "archive",
    "CRS text",       "foreign"};

/// The whole gallery, or one format of it: made anew by every call, with other places, sizes and aims for every seed.
[[nodiscard]] std::vector<HostileFile> hostile_files(const HostileAims& aims, std::mt19937_64& rng);

}  // namespace floeplan::ingest

#pragma once

#include <cstdint>
#include <filesystem>

namespace floeplan::bench {

/// Number type of the currents in a file.
enum class Numbers {
  full,   // float32
  packed  // int16 in steps of 1 mm/s
};

/// Shape of the file: hours, depths, latitudes and longitudes of the two components.
struct OceanShape {
  std::size_t times{};
  std::size_t depths{};
  std::size_t rows{};
  std::size_t columns{};
};

/// Writes an uncompressed NetCDF-4 file of currents, similar to a model's: travelling waves that fade with
/// depth, noise of the size of eddies, and land. The same shape and numbers give the same file.
/// Errors   std::runtime_error when the file cannot be written
void write_ocean(const std::filesystem::path& file, const OceanShape& shape, Numbers numbers);

}  // namespace floeplan::bench

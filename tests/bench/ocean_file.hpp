#pragma once

#include <cstdint>
#include <filesystem>

namespace floeplan::bench {

/// Numbers of a model's currents in a file.
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

/// Writes a NetCDF-4 file of currents, not compressed, as a model might give them: travelling waves that fade with
/// depth, eddies' worth of noise, and land. The same for the same shape and numbers.
/// Errors   std::runtime_error when the file cannot be written
void write_ocean(const std::filesystem::path& file, const OceanShape& shape, Numbers numbers);

}  // namespace floeplan::bench

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/demo/raster_frame.hpp"

namespace floeplan::demo {

/// Sea ice over a frame at one time; masked nodes are written as missing.
struct IceLayer {
  std::vector<double> concentration;  // 0 to 1
  std::vector<double> thickness_m;
  std::vector<bool> masked;
};

/// The contents of an ice file except its values.
struct IceFile {
  std::string title;
  std::string comment;
  RasterFrame frame;
  std::vector<core::UtcTime> times;
  std::function<IceLayer(core::UtcTime time)> layer;
};

/// Writes `siconc` and `sithick` [time][latitude][longitude] as CF-1.8 NetCDF-4, int16 in steps of 0.0001 and of
/// 1 mm. The same content gives the same bytes.
/// Errors   std::runtime_error when the file cannot be written
void write_ice(const std::filesystem::path& file, const IceFile& content);

}  // namespace floeplan::demo

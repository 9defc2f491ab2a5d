#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/demo/raster_frame.hpp"
#include "storage/demo/stream_function.hpp"

namespace floeplan::demo {

/// Currents over a frame at one depth and time, m/s towards east and north; masked nodes are written as
/// missing.
struct CurrentLayer {
  Flow flow;
  std::vector<bool> masked;
};

/// The contents of a currents file except its values.
struct CurrentFile {
  std::string title;
  std::string comment;
  RasterFrame frame;
  std::vector<double> depth_m;  // ascending, positive down
  std::vector<core::UtcTime> times;
  std::function<CurrentLayer(core::UtcTime time, double depth_m)> layer;
};

/// Writes `uo` and `vo` [time][depth][latitude][longitude] as CF-1.8 NetCDF-4, int16 in steps of 0.5 mm/s.
/// The file has no date of creation and no history, so the same content gives the same bytes.
/// Errors   std::runtime_error when the file cannot be written
void write_currents(const std::filesystem::path& file, const CurrentFile& content);

}  // namespace floeplan::demo

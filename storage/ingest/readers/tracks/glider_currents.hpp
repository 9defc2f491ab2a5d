#pragma once

#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/readers/tracks/track_builder.hpp"

namespace floeplan::ingest {

/// When the rows of a file begin and end.
struct TimeSpanOfRows {
  core::UtcTime first;
  core::UtcTime last;
};

/// Names of the variables that hold the depth-averaged currents of a file; empty where there are none.
[[nodiscard]] std::vector<std::string> names_of_currents(const NetcdfFile& file);

/// Adds the depth-averaged currents of a file to its track: see read_glider_netcdf. A current that states no time is
/// that of the middle of the rows. What is left out is told.
/// Errors   values that cannot be read
[[nodiscard]] Checked<bool> add_currents(const NetcdfFile& file, const TimeSpanOfRows& rows,
                                         TrackBuilder& track);

}  // namespace floeplan::ingest

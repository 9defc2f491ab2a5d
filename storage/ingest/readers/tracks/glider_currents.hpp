#pragma once

#include <vector>

#include "storage/ingest/formats/netcdf/netcdf_file.hpp"
#include "storage/ingest/readers/tracks/track_builder.hpp"

namespace floeplan::ingest {

/// Time of the first and of the last row of a file.
struct TimeSpanOfRows {
  core::UtcTime first;
  core::UtcTime last;
};

/// Names of the variables with the depth-averaged currents of a file; empty if there are none.
[[nodiscard]] std::vector<std::string> names_of_currents(const NetcdfFile& file);

/// Adds the depth-averaged currents of a file to its track; see read_glider_netcdf. A current without a time
/// gets the middle of the rows' time span. Warnings tell what was ignored.
/// Errors   values that cannot be read
[[nodiscard]] Checked<bool> add_currents(const NetcdfFile& file, const TimeSpanOfRows& rows,
                                         TrackBuilder& track);

}  // namespace floeplan::ingest

#pragma once

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/files/file_group.hpp"

namespace floeplan::ingest {

/// One track from the logs of a Slocum, text, NetCDF or binary, with the lists of sensors of the latter: the segments of one
/// mission in their order. Times are m_present_time, places m_gps_lat and m_gps_lon, else m_lat and m_lon, in packed
/// or decimal degrees; 69696969 is no position. Currents: see SlocumDives.
/// Errors   every file that cannot be read; a log without times or positions
[[nodiscard]] Checked<PreparedDataset> read_slocum_tracks(const FileGroup& files,
                                                          const core::ProgressCallback& progress);

}  // namespace floeplan::ingest

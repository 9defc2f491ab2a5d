#pragma once

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/files/file_group.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// One track from the logs of a Seaglider's dives (.log), with the depths of their engineering records (.eng) where they
/// are given: the dives of one mission in their order. Places are fixes; depths lie between them. The current of a dive
/// is that of its log ($CURRENT), in the middle of the dive: see read_seaglider_log.
/// Errors   every file that cannot be read; no fix in any of them
[[nodiscard]] Checked<PreparedDataset> read_seaglider_logs(const FileGroup& files,
                                                           const core::ProgressCallback& progress);

/// Whether a file is what the basestation computes of one dive of a Seaglider: p1800001.nc.
[[nodiscard]] bool is_seaglider_dive(const NetcdfFile& file);

/// The mission that the NetCDF file of a dive names: the same in all dives of a mission.
[[nodiscard]] std::string seaglider_mission_of(const NetcdfFile& file);

/// Reads one track from the NetCDF files of dives:
///  - fixes of log_gps_time, log_gps_lat and log_gps_lon
///  - ctd_time and ctd_depth, else time and depth, with the reckoned latitude and longitude of the former
///  - depth_avg_curr_east and _north in their units, towards true east and north, in the middle of the dive
/// What latlong_qc and depth_avg_curr_qc call probably bad, bad or missing (3, 4, 9) is left out.
/// Source   iop-apl-uw/basestation3 BaseNetCDF.py and QC.py
/// Errors   no fixes; times without a known reference
[[nodiscard]] Checked<PreparedDataset> read_seaglider_netcdf(const FileGroup& files,
                                                             const core::ProgressCallback& progress);

}  // namespace floeplan::ingest

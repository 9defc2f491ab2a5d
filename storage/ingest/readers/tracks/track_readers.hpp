#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/files/file_group.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// One track from the logs of a Slocum, text, NetCDF or binary, with the lists of sensors of the latter: the segments of one
/// mission in their order. Times are m_present_time, places m_gps_lat and m_gps_lon, else m_lat and m_lon, in packed
/// or decimal degrees; 69696969 is no position. Currents: see SlocumDives.
/// Errors   every file that cannot be read; a log without times or positions
[[nodiscard]] Checked<PreparedDataset> read_slocum_tracks(const FileGroup& files,
                                                          const core::ProgressCallback& progress);

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

/// Whether a text begins as the navigation (gli) or the payload (pld1) of a SeaExplorer does.
[[nodiscard]] bool is_seaexplorer_text(std::string_view head);

/// Which file of a glider's mission a file is, by its name: "sea035.6.gli.sub.12".
struct SeaexplorerName {
  std::string glider;     // "sea035"
  std::string mission{};  // "sea035.6.gli": the same of all files of one kind; empty: the name does not say
  int dive{};
};
[[nodiscard]] SeaexplorerName seaexplorer_name_of(const std::filesystem::path& file);

/// One track from the navigation or the payload of a SeaExplorer, its dives in any order. Columns are separated by
/// semicolons: Timestamp or PLD_REALTIMECLOCK (DD/MM/YYYY HH:MM:SS in UTC), Lat and Lon or NAV_LATITUDE and
/// NAV_LONGITUDE in packed degrees, Depth or NAV_DEPTH in metres, NavState or NAV_RESOURCE.
/// Places   where the vehicle is at the surface (state 116) its fixes; below, what it reckons, where the position
///          changes: firmware that does not reckon repeats its last fix, which is no place there
/// Currents none: these files hold none
/// Source   states: dankelley/oceanglider, navState; columns: c-proof/pyglider, seaexplorer.py
/// Errors   no time, latitude or longitude among the columns; no row with a place
[[nodiscard]] Checked<PreparedDataset> read_seaexplorer_texts(const FileGroup& files,
                                                              const core::ProgressCallback& progress);

/// Whether a file follows a glider on its way and holds no field: by the names that the formats of the IOOS National
/// Glider Data Assembly Center (profile_id, lat_uv) and OceanGliders OG1 (TRAJECTORY) demand, or because it calls
/// itself a trajectory and goes to depths.
[[nodiscard]] bool is_glider_track(const NetcdfFile& file);

/// The name of the trajectory that the file is a part of; empty when it has none, or several.
[[nodiscard]] std::string trajectory_of(const NetcdfFile& file);

/// One track from the files of a trajectory, in any order.
///  - time, latitude and longitude along one dimension; depth, else pressure, along the same one
///  - u and v, WATERCURRENTS_U and _V, or what has their standard names: depth-averaged currents, alone or many, with
///    time_uv, lat_uv and lon_uv where they are. A current that is repeated from row to row counts once, in the middle
///    of its rows. Its unit must be a known one of speed, or it is left out
///  - flags of quality named after a variable (lat_qc) or in its ancillary_variables: what they call bad is left out
/// Reads in blocks, so memory does not grow with the file.
/// Source   depth from pressure: Saunders 1981, Practical conversion of pressure to depth, J. Phys. Oceanogr. 11,
///          573-574
/// Errors   no time, latitude and longitude along one dimension; times without a known reference; several trajectories
[[nodiscard]] Checked<PreparedDataset> read_glider_netcdf(const FileGroup& files,
                                                          const core::ProgressCallback& progress);

}  // namespace floeplan::ingest

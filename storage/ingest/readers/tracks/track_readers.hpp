#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/files/file_group.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// One track from the logs of one mission of a Slocum, in the order of its segments: text, NetCDF or binary,
/// the last with their sensor caches. Times are m_present_time, positions m_gps_lat and m_gps_lon, or else
/// m_lat and m_lon, in packed or decimal degrees; 69696969 means no position. Currents: see SlocumDives.
/// Errors   a file that cannot be read (each is reported); a log without times or positions
[[nodiscard]] Checked<PreparedDataset> read_slocum_tracks(const FileGroup& files,
                                                          const core::ProgressCallback& progress);

/// One track from the logs of a Seaglider's dives (.log), in the order of the dives, with the depths of their
/// engineering records (.eng) if given. Positions are fixes; positions of depths are interpolated. The
/// current of a dive is that of its log ($CURRENT), in the middle of the dive; see read_seaglider_log.
/// Errors   a file that cannot be read (each is reported); no fix in any file
[[nodiscard]] Checked<PreparedDataset> read_seaglider_logs(const FileGroup& files,
                                                           const core::ProgressCallback& progress);

/// Whether a file is the basestation's NetCDF file of one dive of a Seaglider: p1800001.nc.
[[nodiscard]] bool is_seaglider_dive(const NetcdfFile& file);

/// The mission in the NetCDF file of a dive; equal for all dives of the mission.
[[nodiscard]] std::string seaglider_mission_of(const NetcdfFile& file);

/// Reads one track from the NetCDF files of dives:
///  - fixes of log_gps_time, log_gps_lat and log_gps_lon
///  - ctd_time and ctd_depth, with the reckoned latitude and longitude; otherwise time and depth
///  - depth_avg_curr_east and _north in their units, towards true east and north, in the middle of the dive
/// Values that latlong_qc and depth_avg_curr_qc mark as probably bad, bad or missing (3, 4, 9) are ignored.
/// Source   iop-apl-uw/basestation3 BaseNetCDF.py and QC.py
/// Errors   no fixes; times without a known reference
[[nodiscard]] Checked<PreparedDataset> read_seaglider_netcdf(const FileGroup& files,
                                                             const core::ProgressCallback& progress);

/// Whether a text begins like the navigation file (gli) or the payload file (pld1) of a SeaExplorer.
[[nodiscard]] bool is_seaexplorer_text(std::string_view head);

/// Identifies a file of a glider's mission by its name: "sea035.6.gli.sub.12".
struct SeaexplorerName {
  std::string glider;     // "sea035"
  std::string mission{};  // "sea035.6.gli": the same of all files of one kind; empty: the name does not say
  int dive{};
};
[[nodiscard]] SeaexplorerName seaexplorer_name_of(const std::filesystem::path& file);

/// One track from the navigation or payload files of a SeaExplorer, one file per dive, in any order. Columns
/// are separated by semicolons: Timestamp or PLD_REALTIMECLOCK (DD/MM/YYYY HH:MM:SS in UTC), Lat and Lon or
/// NAV_LATITUDE and NAV_LONGITUDE in packed degrees, Depth or NAV_DEPTH in metres, NavState or NAV_RESOURCE.
/// Places   fixes while the vehicle is at the surface (state 116). Below the surface only reckoned positions
///          that change are used: firmware without dead reckoning repeats its last fix
/// Currents none: these files hold none
/// Source   states: dankelley/oceanglider, navState; columns: c-proof/pyglider, seaexplorer.py
/// Errors   no column of time, latitude or longitude; no row with a position
[[nodiscard]] Checked<PreparedDataset> read_seaexplorer_texts(const FileGroup& files,
                                                              const core::ProgressCallback& progress);

/// Whether a file is the track of a glider, not a field. It is if it has names that IOOS NGDAC (profile_id,
/// lat_uv) or OceanGliders OG1 (TRAJECTORY) require, or if it declares itself a trajectory and has depths.
[[nodiscard]] bool is_glider_track(const NetcdfFile& file);

/// The name of the trajectory that the file belongs to; empty if it has none or several.
[[nodiscard]] std::string trajectory_of(const NetcdfFile& file);

/// One track from the files of a trajectory, given in any order.
///  - time, latitude and longitude along one dimension; depth, or else pressure, along the same dimension
///  - u and v, WATERCURRENTS_U and _V, or variables with their standard names: depth-averaged currents, one
///    or many, with time_uv, lat_uv and lon_uv if present. A current that is repeated from row to row counts
///    once, in the middle of its rows. Currents with an unknown unit are ignored
///  - quality flags named after a variable (lat_qc) or in its ancillary_variables: bad values are ignored
/// Reads in blocks, so memory does not grow with the file's size.
/// Source   depth from pressure: Saunders 1981, Practical conversion of pressure to depth, J. Phys. Oceanogr. 11,
///          573-574
/// Errors   no time, latitude and longitude along one dimension; times without a known reference; several trajectories
[[nodiscard]] Checked<PreparedDataset> read_glider_netcdf(const FileGroup& files,
                                                          const core::ProgressCallback& progress);

}  // namespace floeplan::ingest

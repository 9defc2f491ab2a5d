#pragma once

#include <string>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/files/file_group.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

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

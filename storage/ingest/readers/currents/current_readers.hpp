#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/ingest_options.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/common/refusal.hpp"
#include "storage/ingest/files/file_group.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

/// Currents from one NetCDF file, or from several files that belong together: one for each component, and
/// tables of positions, angles and depths. Regular grids are stored on their axes, all other layouts at their
/// own points.
/// `stated_crs`  the projection for a file that states none
/// `wanted`      the components to use if there are several pairs
/// Errors   see find_velocity_pair, rectilinear_currents, curvilinear_currents and prepare_currents
[[nodiscard]] Checked<PreparedDataset> read_currents(const NetcdfFiles& files,
                                                     const std::optional<std::string>& stated_crs,
                                                     const WantedVariables& wanted,
                                                     const core::ProgressCallback& progress);

/// Currents from a GRIB2 file: the eastward and northward components (discipline 10 oceanography, category 1,
/// numbers 2 and 3) at every time and depth. Grids of latitude and longitude are stored on their axes, others
/// at their own points. Vectors along the grid are rotated to east and north.
/// Errors   those of grib_fields; no currents, or speed and direction instead; a component missing at a time
///          or depth;
///          fields on different grids
[[nodiscard]] Checked<PreparedDataset> read_grib_currents(const std::filesystem::path& file,
                                                          const core::ProgressCallback& progress);

/// The same for the wind 10 m above the ground (discipline 0, category 2, numbers 2 and 3, surface 103);
/// other heights are ignored.
[[nodiscard]] Checked<PreparedDataset> read_grib_wind(const std::filesystem::path& file,
                                                      const core::ProgressCallback& progress);

/// Depth-averaged currents of ADCIRC, from fort.64, at the nodes of fort.14. A node is dry where fort.63 says
/// so, or, without fort.63, where its current is exactly zero. `options.time` is the start of the run, from
/// which the files count their times.
/// Errors   fort.14 missing; no start of the run; files with different meshes or times; those of AdcircOutput
///          and read_adcirc_mesh
[[nodiscard]] Checked<PreparedDataset> read_adcirc_currents(const FileGroup& files,
                                                            const IngestOptions& options,
                                                            const core::ProgressCallback& progress);

/// Surface currents of IHO S-111 on a regular grid, at separate places or on a triangulated mesh: a speed,
/// and the direction towards which the water goes.
/// Depth    the file's: the depth of the currents below the surface, or the middle of the layer over which
///          they are averaged
/// Errors   those of s100_coverage and s100_points; a record without a time; a unit that is not a speed; a
///          height above the sea bed
/// Source   IHO S-111 edition 2.0.0, clause 12 with table 12-11, and edition 1.0.1, table 12.1
[[nodiscard]] Checked<PreparedDataset> read_s111_currents(const std::filesystem::path& file,
                                                          const core::ProgressCallback& progress);

/// Whether a variable is a component of the wind near the sea, whether or not it can be used.
[[nodiscard]] bool holds_wind(const NetcdfFile& file);

/// The wind 10 m above the sea from a NetCDF file, towards true east and true north. If there are several
/// heights, only 10 m is read. Grids that are neither geographic nor polar stereographic are stored at their
/// own points.
/// `stated_crs`  the projection for a file that states none
/// Errors   a single component; other heights only; no time; those of velocity_input and prepare_currents
[[nodiscard]] Checked<PreparedDataset> read_wind(const std::shared_ptr<const NetcdfFile>& file,
                                                 const std::optional<std::string>& stated_crs,
                                                 const core::ProgressCallback& progress);

/// Whether read_wind would accept the layout of the wind in the file. If so, the wind is worth reading beside
/// other data.
[[nodiscard]] bool wind_is_readable(const std::shared_ptr<const NetcdfFile>& file);

}  // namespace floeplan::ingest

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

/// Currents from one NetCDF file, or from several that belong together: the two components apart, and tables of
/// positions, angles and depths. Regular grids are kept on their axes, every other layout at its own points.
/// `stated_crs`  the projection of a file that states none
/// `wanted`      the components to use where there are several pairs
/// Errors   see find_velocity_pair, rectilinear_currents, curvilinear_currents and prepare_currents
[[nodiscard]] Checked<PreparedDataset> read_currents(const NetcdfFiles& files,
                                                     const std::optional<std::string>& stated_crs,
                                                     const WantedVariables& wanted,
                                                     const core::ProgressCallback& progress);

/// Currents from a GRIB2 file: the eastward and northward components of oceanography (discipline 10, category 1,
/// numbers 2 and 3) at every time and depth. Grids of latitude and longitude are kept on their axes, others at their own points;
/// vectors along the grid are turned to east and north.
/// Errors   see grib_fields; no currents, or speed and direction instead; a component missing at a time or depth;
///          fields on different grids
[[nodiscard]] Checked<PreparedDataset> read_grib_currents(const std::filesystem::path& file,
                                                          const core::ProgressCallback& progress);

/// The same for the wind 10 m above the ground (discipline 0, category 2, numbers 2 and 3, surface 103); other heights
/// are passed over.
[[nodiscard]] Checked<PreparedDataset> read_grib_wind(const std::filesystem::path& file,
                                                      const core::ProgressCallback& progress);

/// Currents of ADCIRC averaged over depth, from its fort.64, at the nodes of its fort.14. A node is dry where its fort.63
/// says so; without that file where its current is exactly zero. `options.time` is the start of the run, from which the
/// files count.
/// Errors   fort.14 missing; no start; files of different meshes or times; see AdcircOutput and read_adcirc_mesh
[[nodiscard]] Checked<PreparedDataset> read_adcirc_currents(const FileGroup& files,
                                                            const IngestOptions& options,
                                                            const core::ProgressCallback& progress);

/// Surface currents of IHO S-111 on a regular grid, at separate places or on a triangulated mesh: a speed, and the
/// direction towards which the water goes.
/// Depth    as the file says: that of the currents below the surface, or the middle of the layer that they are means of
/// Errors   as s100_coverage and s100_points; no time of a record; a unit that is no speed; a height above the sea bed
/// Source   IHO S-111 edition 2.0.0, clause 12 with table 12-11, and edition 1.0.1, table 12.1
[[nodiscard]] Checked<PreparedDataset> read_s111_currents(const std::filesystem::path& file,
                                                          const core::ProgressCallback& progress);

/// Whether any variable claims to be a component of the wind near the sea, whether or not it can be used.
[[nodiscard]] bool holds_wind(const NetcdfFile& file);

/// The wind 10 m above the sea from a NetCDF file, towards true east and true north. Of wind at several heights the one
/// at 10 m is taken. Grids that are neither geographic nor polar stereographic are kept at their own points.
/// `stated_crs`  the projection of a file that states none
/// Errors   one component alone; other heights only; no time; see velocity_input and prepare_currents
[[nodiscard]] Checked<PreparedDataset> read_wind(const std::shared_ptr<const NetcdfFile>& file,
                                                 const std::optional<std::string>& stated_crs,
                                                 const core::ProgressCallback& progress);

/// Whether that would not be refused for its layout, so that the wind is worth reading beside other data.
[[nodiscard]] bool wind_is_readable(const std::shared_ptr<const NetcdfFile>& file);

}  // namespace floeplan::ingest

#pragma once

#include <optional>
#include <string>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
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

}  // namespace floeplan::ingest

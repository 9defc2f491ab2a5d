#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

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

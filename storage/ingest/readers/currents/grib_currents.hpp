#pragma once

#include <filesystem>

#include "engine/core/progress.hpp"
#include "storage/ingest/common/prepared_dataset.hpp"

namespace floeplan::ingest {

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

}  // namespace floeplan::ingest

#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// When the model run began that a file holds, by its variable of the standard name forecast_reference_time; empty
/// where it states none, several, or one that cannot be decoded.
/// Source  CF standard name table, forecast_reference_time: "the data time, the time of the analysis from which the
///         forecast was made"
[[nodiscard]] std::optional<core::UtcTime> model_run_of(const NetcdfFile& file);

}  // namespace floeplan::ingest

#pragma once

#include <optional>

#include "engine/core/units.hpp"
#include "storage/ingest/formats/netcdf/netcdf_file.hpp"

namespace floeplan::ingest {

/// Start of the model run that a file holds, from its variable with the standard name
/// forecast_reference_time; empty if the file states none or several, or the time cannot be decoded.
/// Source  CF standard name table, forecast_reference_time: "the data time, the time of the analysis from which the
///         forecast was made"
[[nodiscard]] std::optional<core::UtcTime> model_run_of(const NetcdfFile& file);

}  // namespace floeplan::ingest

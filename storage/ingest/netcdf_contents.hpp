#pragma once

#include <string>
#include <vector>

#include "storage/ingest/data_format.hpp"

namespace floeplan::ingest {

/// Opens a NetCDF file or a Zarr store and finds the kinds of data that it holds: at its top level, else in the one of
/// its groups that holds some.
/// Errors   GDAL's own words when it cannot be opened; nothing of use in it, and what it holds instead; data in several
///          groups
[[nodiscard]] Checked<bool> look_into_netcdf(RecognisedFile& file, const Expectation& expected);

/// Reads one of those kinds.
[[nodiscard]] Checked<PreparedDataset> read_netcdf(const Reading& reading);

/// Sea ice and depths beside currents that are on a bent grid are not taken along: nobody should believe them stored.
void warn_of_what_is_left(const RecognisedFile& file, Messages& warnings);

}  // namespace floeplan::ingest

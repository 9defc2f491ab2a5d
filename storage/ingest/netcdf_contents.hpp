#pragma once

#include <optional>
#include <string>
#include <vector>

#include "storage/ingest/data_format.hpp"

namespace floeplan::ingest {

/// Opens a NetCDF file or a Zarr store and finds its kinds of data: at the top level, or else in the only
/// group that holds data.
/// Errors   it cannot be opened (GDAL's words); it holds nothing that this program reads (the message says
///          what it holds);
///          several groups hold data
[[nodiscard]] Checked<bool> look_into_netcdf(RecognisedFile& file, const Expectation& expected);

/// The refusal of a file that was said to hold sea ice, but whose only plane says nothing of what it is; nullopt if it has
/// no such plane.
[[nodiscard]] std::optional<messages::Message> ice_not_named(const NetcdfFile& file);

/// Reads one of the kinds that look_into_netcdf found.
[[nodiscard]] Checked<PreparedDataset> read_netcdf(const Reading& reading);

/// Warns that sea ice and depths beside currents on a curvilinear grid are not stored, so that nobody relies
/// on them.
void warn_of_what_is_left(const RecognisedFile& file, Messages& warnings);

}  // namespace floeplan::ingest

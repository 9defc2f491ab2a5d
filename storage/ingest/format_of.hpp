#pragma once

#include <filesystem>

#include "storage/ingest/data_format.hpp"

namespace floeplan::ingest {

/// The row of data_formats() for a file, found by its first bytes; the file's name plays no part. Never null.
/// `icebergs_stated`  the user says that the file holds icebergs; a table then needs no column that says so
/// Errors   the file has no known format (chart pictures, archives and others are named); the file is empty;
///          the folder
///          is no store; the format's check refuses the file, as for a NetCDF file shorter than its header
///          says
[[nodiscard]] Checked<const DataFormat*> format_of(const std::filesystem::path& file,
                                                   bool icebergs_stated = false);

}  // namespace floeplan::ingest

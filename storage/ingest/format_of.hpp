#pragma once

#include <filesystem>

#include "storage/ingest/data_format.hpp"

namespace floeplan::ingest {

/// The row of data_formats() that a file is of, told by its first bytes; its name plays no part. Never null.
/// `icebergs_stated`  the user says that the file holds icebergs: tables need no column of their own for them
/// Errors   every other file, by name where it is known (chart pictures, archives, ...); an empty file; a folder that is
///          no store; what the format's check refuses, as a classic NetCDF file that is shorter than its header says
[[nodiscard]] Checked<const DataFormat*> format_of(const std::filesystem::path& file,
                                                   bool icebergs_stated = false);

}  // namespace floeplan::ingest

#pragma once

#include <filesystem>

#include "storage/ingest/data_format.hpp"

namespace floeplan::ingest {

/// The row of data_formats() for a file. It is found by the first bytes of the file, never by the file's
/// name. Never null.
/// `icebergs_stated`  the user says that the file holds icebergs; a table then needs no column that says so
/// Errors   the file has no known format (chart pictures, archives and others are named); the file is empty;
///          the folder is no store; the format's own check refuses the file, for example a NetCDF file that
///          is shorter than its header says
[[nodiscard]] Checked<const DataFormat*> format_of(const std::filesystem::path& file,
                                                   bool icebergs_stated = false);

}  // namespace floeplan::ingest

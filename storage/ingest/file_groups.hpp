#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "storage/ingest/files/file_group.hpp"

namespace floeplan::ingest {

/// Puts together what belongs together, told by content: a file with one component of the currents and one with the
/// other for the same times, and files with tables of positions, angles and depths on the grid of a file of currents.
/// The files of one trajectory of a glider, and the segments of one mission of a Slocum, belong together.
/// The grid file of a tide's model belongs to each file of its transports.
/// The parts of a shapefile, and what else lies beside a file under its name, belong to it by that name.
/// Files keep their order; a file of tables that belongs to nothing is a group of its own.
/// `looking_at`  called with the number of each file before it is opened; may be empty
[[nodiscard]] std::vector<FileGroup> group_files(const std::vector<std::filesystem::path>& files,
                                                 const std::function<void(std::size_t)>& looking_at = {});

}  // namespace floeplan::ingest

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "storage/ingest/files/file_group.hpp"

namespace floeplan::ingest {

/// Groups files into datasets, by their content: a file with one component of the currents and the file with
/// the other component for the same times; and files with positions, angles and depths on the grid of a file
/// of currents. The files of one trajectory of a glider, and the segments of one mission of a Slocum, make
/// one dataset. The grid file of a tide model joins the group of each of its transport files. Only the parts
/// of a shapefile and other sidecar files are grouped by their name. Files keep their order; a file with
/// positions or depths that match no currents makes a group of its own.
/// `looking_at`  called with the index of each file before it is opened; may be empty
[[nodiscard]] std::vector<FileGroup> group_files(const std::vector<std::filesystem::path>& files,
                                                 const std::function<void(std::size_t)>& looking_at = {});

}  // namespace floeplan::ingest

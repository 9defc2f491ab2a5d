#pragma once

#include <filesystem>
#include <vector>

#include "storage/sandbox/landlock.hpp"

namespace floeplan::ingest {

/// Makes every library read its settings and find its data now, while this process may still open files, and
/// keeps them from loading plugins.
void prepare_libraries();

/// The files that a process needs to read `files`: the files themselves; files beside them with the same name
/// and another ending, such as parts of a shapefile and updates of a chart; the sensor lists beside logs of
/// Slocum gliders; the data of the libraries. The process may write only to `staging`.
[[nodiscard]] sandbox::FileNeeds needs_of_reader(const std::vector<std::filesystem::path>& files,
                                                 const std::filesystem::path& staging);

}  // namespace floeplan::ingest

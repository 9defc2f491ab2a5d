#pragma once

#include <filesystem>
#include <vector>

#include "storage/sandbox/landlock.hpp"

namespace floeplan::ingest {

/// Has every library read its settings and find its data now, as long as this process may open files, and keeps them
/// from loading plugins.
void prepare_libraries();

/// What a process that reads `files` needs: the files; what lies beside them and has their name with another ending, as
/// the parts of a shapefile and the updates of a chart have; beside logs of Slocum gliders the lists of their sensors;
/// the data of the libraries. It writes to `staging` alone.
[[nodiscard]] sandbox::FileNeeds needs_of_reader(const std::vector<std::filesystem::path>& files,
                                                 const std::filesystem::path& staging);

}  // namespace floeplan::ingest

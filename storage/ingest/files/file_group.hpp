#pragma once

#include <filesystem>
#include <vector>

namespace floeplan::ingest {

/// Files that make one dataset: the first holds a component of the currents or the whole data, the others what belongs
/// to it. Most groups are of one file.
using FileGroup = std::vector<std::filesystem::path>;

}  // namespace floeplan::ingest

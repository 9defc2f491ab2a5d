#pragma once

#include <filesystem>
#include <vector>

namespace floeplan::ingest {

/// Files that make one dataset. The first holds all data or one component of the currents, the others the
/// rest. Most groups have one file.
using FileGroup = std::vector<std::filesystem::path>;

}  // namespace floeplan::ingest

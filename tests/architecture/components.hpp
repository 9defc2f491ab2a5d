#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace floeplan::support {

/// Components below engine, storage, api and server of the source tree at `root` (a component is X.hpp and X.cpp
/// together) that include each other in a ring.
/// Returns  one line for each ring, "component component ...", each a path without its ending, in path order
/// Source   Tarjan 1972, Depth-first search and linear graph algorithms, SIAM J. Comput. 1, doi:10.1137/0201010
[[nodiscard]] std::vector<std::string> include_rings(const std::filesystem::path& root);

/// Number of code files directly in each folder below engine, storage, api, server and tests, without its
/// subfolders.
[[nodiscard]] std::map<std::string, int> code_files_by_folder(const std::filesystem::path& root);

}  // namespace floeplan::support

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace floeplan::support {

/// Checks every #include below engine, storage, api and server of the source tree at `root`: the arrows
/// between the folders, and the libraries that only certain folders may know.
/// Returns  one line for each fault, "file:line: what is wrong", in path order; empty when all is well
[[nodiscard]] std::vector<std::string> broken_include_rules(const std::filesystem::path& root);

}  // namespace floeplan::support

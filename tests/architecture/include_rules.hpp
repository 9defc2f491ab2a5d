#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace floeplan::support {

/// Checks every #include below engine, storage, api and server of the source tree at `root`: which folders
/// may use which other folders, and which folders may use which libraries.
/// Returns  one line for each fault, "file:line: what is wrong", in path order; empty if there is none
[[nodiscard]] std::vector<std::string> broken_include_rules(const std::filesystem::path& root);

}  // namespace floeplan::support

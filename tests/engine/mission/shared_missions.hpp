#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace floeplan::support {

/// Folder of the shared mission samples, collected from real vehicles and not part of this repository; tests
/// that need it skip where it is not there.
[[nodiscard]] std::filesystem::path shared_missions();

/// Every sample, by path: files that have an expectation beside them.
[[nodiscard]] std::vector<std::filesystem::path> shared_mission_files();

[[nodiscard]] std::string bytes_of(const std::filesystem::path& file);

}  // namespace floeplan::support

#pragma once

#include <filesystem>

namespace floeplan::repository {

/// A mark in a folder that holds a store, or held one, so that without its database it is not taken for a new one.
void mark_as_store(const std::filesystem::path& folder);
[[nodiscard]] bool is_marked_as_store(const std::filesystem::path& folder);

}  // namespace floeplan::repository

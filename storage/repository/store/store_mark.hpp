#pragma once

#include <filesystem>

namespace floeplan::repository {

/// Marks a folder of a store. If its database is lost, the folder is not mistaken for an empty one and given
/// a new store.
void mark_as_store(const std::filesystem::path& folder);
[[nodiscard]] bool is_marked_as_store(const std::filesystem::path& folder);

}  // namespace floeplan::repository

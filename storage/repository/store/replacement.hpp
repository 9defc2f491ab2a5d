#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/progress.hpp"
#include "storage/repository/store/stored_things.hpp"

namespace floeplan::repository {

/// Result of replacing a store's database.
struct Replacement {
  std::vector<StoredThing> lost;  // things that could not be read and are not in the new database
  std::filesystem::path kept;     // path of the old database; empty: there was none
};

/// Migrates a store with an older schema or without checksums.
/// Errors   std::runtime_error for a newer schema; sql::Failure when anything is damaged, or the store is in
///          use
Replacement bring_up_to_date(const std::filesystem::path& store, const core::ProgressCallback& progress = {});

/// Rebuilds a damaged store from its undamaged things.
/// Errors   sql::Failure when its schema cannot be read, or the store is in use
Replacement repair_store(const std::filesystem::path& store, const core::ProgressCallback& progress = {});

/// Replaces a store by a backup of this schema or an older one.
/// Errors   std::runtime_error, before anything is changed, for a file that is not a store, has a newer
///          schema or is damaged; sql::Failure when the store is in use
Replacement restore_store(const std::filesystem::path& store, const std::filesystem::path& backup,
                          const core::ProgressCallback& progress = {});

}  // namespace floeplan::repository

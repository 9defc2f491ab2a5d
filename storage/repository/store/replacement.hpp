#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/progress.hpp"
#include "storage/repository/store/stored_things.hpp"

namespace floeplan::repository {

/// A database that was put in the place of a store's.
struct Replacement {
  std::vector<StoredThing> lost;  // what could not be read, and is not in it
  std::filesystem::path kept;     // the database that was there before; empty: there was none
};

/// Brings a store with an older schema, or without checksums, up to date.
/// Errors   std::runtime_error for a newer schema; sql::Failure when anything is damaged, or somebody uses the store
Replacement bring_up_to_date(const std::filesystem::path& store, const core::ProgressCallback& progress = {});

/// Saves what is whole of a damaged store.
/// Errors   sql::Failure when its schema cannot be read, or somebody uses the store
Replacement repair_store(const std::filesystem::path& store, const core::ProgressCallback& progress = {});

/// Puts a backup, of this schema or an older one, in the place of a store.
/// Errors   std::runtime_error for a file that is no store, of a newer schema or damaged, before anything is changed;
///          sql::Failure when somebody uses the store
Replacement restore_store(const std::filesystem::path& store, const std::filesystem::path& backup,
                          const core::ProgressCallback& progress = {});

}  // namespace floeplan::repository

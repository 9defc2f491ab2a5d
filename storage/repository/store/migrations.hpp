#pragma once

#include <filesystem>

#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Opens the store in this folder, creating it or bringing it up to this program's schema first.
/// Errors   std::runtime_error for a store that a newer program has written, for a file that is damaged or
/// not a store,
///          and when the folder cannot be written
[[nodiscard]] sql::Connection open_store(const std::filesystem::path& store);

/// A store of the same schema whose contents nobody misses after a kill: where data lie until they are complete.
/// The folder exists.
[[nodiscard]] sql::Connection open_scratch_store(const std::filesystem::path& folder);

/// A private, empty store in memory, for tests.
[[nodiscard]] sql::Connection open_store_in_memory();

}  // namespace floeplan::repository

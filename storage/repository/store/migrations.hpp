#pragma once

#include <filesystem>
#include <string>

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

/// Opens the store that a database server keeps, setting it up first where there is none.
/// `address`  as of `sql::Connection::open_at_server`
/// Errors     sql::Failure when the server cannot be reached or refuses
[[nodiscard]] sql::Connection open_store_at_server(const std::string& address);

/// A private, empty store in memory, for tests.
[[nodiscard]] sql::Connection open_store_in_memory();

}  // namespace floeplan::repository

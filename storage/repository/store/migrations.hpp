#pragma once

#include <filesystem>
#include <string>

#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Opens the store in this folder. Creates it, or migrates it to this program's schema, if necessary.
/// Errors   std::runtime_error for a store written by a newer program, for a file that is damaged or not a
///          store, and when the folder cannot be written
[[nodiscard]] sql::Connection open_store(const std::filesystem::path& store);

/// Opens a store of the same schema for temporary data. It may be lost when the process is killed.
/// `folder`  must exist
[[nodiscard]] sql::Connection open_scratch_store(const std::filesystem::path& folder);

/// Opens the store that a database server keeps, setting it up first where there is none.
/// `address`  as in `sql::Connection::open_at_server`
/// Errors     sql::Failure when the server cannot be reached or refuses
[[nodiscard]] sql::Connection open_store_at_server(const std::string& address);

/// A private, empty store in memory, for tests.
[[nodiscard]] sql::Connection open_store_in_memory();

}  // namespace floeplan::repository

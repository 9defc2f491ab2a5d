#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "storage/sql/connection.hpp"

namespace floeplan::support {

/// A new, empty store that nobody else uses: in memory, or, where the tests run beside a database server
/// (`at_database_server`), in a schema of its own at that server.
[[nodiscard]] sql::Connection empty_store();

/// The words that name the store of a folder on a command line: the folder, and beside a database server also a schema of
/// the folder's own at that server.
[[nodiscard]] std::vector<std::string> store_words(const std::filesystem::path& folder);

}  // namespace floeplan::support

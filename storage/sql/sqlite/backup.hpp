#pragma once

#include <filesystem>
#include <string>

namespace SQLite {
class Database;
}

namespace floeplan::sql::sqlite {

/// Writes the whole database in its present state to a new file; others can read and write meanwhile. The
/// file is complete and on disk, or does not exist.
/// Errors   Failure when the file exists, cannot be written, or fails the check afterwards
void back_up(SQLite::Database& database, const std::filesystem::path& file);

/// The fault of a database file's pages and indices, in words; empty if there is none. Reads the whole file
/// and does not change it. A file that is not a database of Floeplan is a fault, too.
/// Errors   Failure when the file cannot be opened
[[nodiscard]] std::string damage_of(const std::filesystem::path& file);

}  // namespace floeplan::sql::sqlite

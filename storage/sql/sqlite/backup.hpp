#pragma once

#include <filesystem>
#include <string>

namespace SQLite {
class Database;
}

namespace floeplan::sql::sqlite {

/// Writes the whole database, as it stands at one moment, into a new file; others go on reading and writing meanwhile.
/// The file is there complete and on disk, or not at all.
/// Errors   Failure when the file exists, cannot be written, or does not come out sound
void back_up(SQLite::Database& database, const std::filesystem::path& file);

/// What is wrong with the pages and indices of a database file that is not to be changed, in words; empty when nothing is.
/// Reads all of it. Also says so when it is no database of ours.
/// Errors   Failure when it cannot be opened
[[nodiscard]] std::string damage_of(const std::filesystem::path& file);

}  // namespace floeplan::sql::sqlite

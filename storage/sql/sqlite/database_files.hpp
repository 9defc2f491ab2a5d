#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace floeplan::sql::sqlite {

/// Marks a database file as Floeplan's in its header ("FLOE"). Files without it are never written to.
inline constexpr std::int32_t application_id = 0x464C4F45;

/// Path of the database of a store.
[[nodiscard]] std::filesystem::path database_in(const std::filesystem::path& store);

/// Paths of all files with data of a store: the database, and its log, which may not exist.
[[nodiscard]] std::vector<std::filesystem::path> database_files_in(const std::filesystem::path& store);

/// The header of a database file, read without opening it as a database; false and 0 if it states nothing.
/// Source  SQLite file format, 1.3: application id at byte 68, user version at byte 60, big-endian
struct DatabaseHeader {
  bool is_store{};        // of Floeplan
  std::int32_t schema{};  // the user version
  bool has_checksums{};
};
[[nodiscard]] DatabaseHeader header_of(const std::filesystem::path& database);

/// Flushes a file, or the names in a folder, to the disk.
/// Errors  Failure when the flush fails
void flush(const std::filesystem::path& path);

/// Merges the log of a database into the database, which is then a single file. Precondition: nobody else
/// uses the store.
/// Errors  Failure when the database is damaged, or is open in a program that does not use StoreUse
void settle(const std::filesystem::path& database);

/// Renames a database that cannot be settled, and its log, so that another can take its place. The database
/// is renamed first: a store without a database is never opened, but a database without its log could be,
/// without the last commits; and an old log would be written into the new database.
/// Returns  the database's new name; empty when only a log existed
[[nodiscard]] std::filesystem::path set_aside(const std::filesystem::path& database, const std::string& why);

/// Puts a finished database, which has no log, in the place of another. The old one is kept beside it under a
/// new name that contains `why`. At every moment one of the two is in place. Precondition: nobody else uses
/// the store.
/// Returns  the old one's new name; empty when there was none
/// Errors   Failure; nothing is then changed
[[nodiscard]] std::filesystem::path put_in_place(const std::filesystem::path& finished,
                                                 const std::filesystem::path& place, const std::string& why);

}  // namespace floeplan::sql::sqlite

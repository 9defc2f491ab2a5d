#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace floeplan::sql::sqlite {

/// Marks a database file as ours in its header ("FLOE"), so that nobody else's file is ever written to.
inline constexpr std::int32_t application_id = 0x464C4F45;

/// The database of a store, in its folder.
[[nodiscard]] std::filesystem::path database_in(const std::filesystem::path& store);

/// All files that the data of a store may lie in: the database, and its log, which is not always there.
[[nodiscard]] std::vector<std::filesystem::path> database_files_in(const std::filesystem::path& store);

/// What the header of a database file says without opening it, as false and 0 where it says nothing.
/// Source  SQLite file format, 1.3: application id at byte 68, user version at byte 60, big-endian
struct DatabaseHeader {
  bool is_store{};        // of Floeplan
  std::int32_t schema{};  // the user version
  bool has_checksums{};
};
[[nodiscard]] DatabaseHeader header_of(const std::filesystem::path& database);

/// Forces a file, or the names in a folder, to the disk.
/// Errors  Failure when that fails
void flush(const std::filesystem::path& path);

/// Moves what the log of a database holds into the database, which is one file then. The caller is alone with the store.
/// Errors  Failure when the database is damaged, or a program that knows no StoreUse has it open
void settle(const std::filesystem::path& database);

/// Takes a database that cannot be settled, and its log, out of the way of the one that comes in its place: the database
/// first. A store without a database is opened by nobody, but one without the log that belongs to it might be, and would
/// then lack what was promised last; and a log that stayed would be written over the database that comes.
/// Returns  the database's new name; empty when only a log was left of it
[[nodiscard]] std::filesystem::path set_aside(const std::filesystem::path& database, const std::string& why);

/// Puts a finished database, which no log belongs to, in the place of another. The other one is kept beside it under a
/// name of its own, which says `why`; at every instant one of the two has the place. The caller is alone with the store.
/// Returns  the other one's new name; empty when there was none
/// Errors   Failure; then the place is as it was
[[nodiscard]] std::filesystem::path put_in_place(const std::filesystem::path& finished,
                                                 const std::filesystem::path& place, const std::string& why);

}  // namespace floeplan::sql::sqlite

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

struct sqlite3;

namespace floeplan::sql::sqlite {

/// Every page of a database ends with a checksum of the rest of it, in bytes that SQLite reserves for this. It is written
/// when a page goes to the database file and compared whenever one is read from it, so that a byte that the disk changed is
/// an error in place of an answer.
/// Format   XXH3, 64 bits, little-endian, in the last 8 bytes; the header (byte 20) says how many bytes are reserved
/// Edges    files without reserved bytes are read and written as they are. Pages in the write-ahead log have none until
///          they are moved to the file (PRAGMA wal_checkpoint); SQLite's own checksums guard them until a program opens it
/// Source   SQLite file format, 1.3.4 "Reserved bytes per page"; XXH3 as libxxhash 0.8 defines it
inline constexpr int checksum_bytes = 8;

/// Name of SQLite's virtual file system that does so, registered by this call; for SQLite::Database and ATTACH. What it
/// finds damaged ends a statement with SQLITE_NOTADB: after SQLITE_CORRUPT a transaction could write no more, and after
/// SQLITE_IOERR it would be undone, so that nothing could be copied round damage.
/// Threads  any
[[nodiscard]] const char* checked_files();

/// Whether a database that nobody of this process has open has checksums, by its header; false of a file that is no
/// database. Whoever closes a file gives back all locks that his process has on it (POSIX, fcntl), those of SQLite, too.
[[nodiscard]] bool has_page_checksums(const std::filesystem::path& database);

/// What the first bytes of a database say of its pages.
struct PageLayout {
  std::size_t page_bytes{};  // 0: no size that a page can have
  bool has_checksums{};
};
inline constexpr std::size_t header_bytes = 100;
[[nodiscard]] PageLayout layout_of_pages(std::span<const std::byte> header);

/// Whether a page is as it was written.
[[nodiscard]] bool is_whole_page(std::span<const std::byte> page);

/// Bytes as they are in the file that SQLite has open already, not compared; fewer at its end.
/// Errors   Failure when the file cannot be read, or was not opened by checked_files
[[nodiscard]] std::vector<std::byte> bytes_in_file(sqlite3* database, std::uint64_t offset,
                                                   std::size_t bytes);

}  // namespace floeplan::sql::sqlite

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

struct sqlite3;

namespace floeplan::sql::sqlite {

/// Each page of a database ends with a checksum of its other bytes, in space that SQLite reserves for such
/// use. The checksum is computed when a page is written to the database file and verified when it is read. A
/// byte that the disk has changed thus causes an error, not a wrong answer.
/// Format   XXH3, 64 bits, little-endian, in the last 8 bytes; byte 20 of the header has the number of
///          reserved bytes
/// Edges    files without reserved bytes are read and written without checksums. Pages in the write-ahead log
///          have none until they are moved to the file (PRAGMA wal_checkpoint); there SQLite's own checksums
///          protect them
/// Source   SQLite file format, 1.3.4 "Reserved bytes per page"; XXH3 as libxxhash 0.8 defines it
inline constexpr int checksum_bytes = 8;

/// Registers the virtual file system for SQLite that does this, and returns its name for SQLite::Database and
/// ATTACH. A damaged page ends a statement with SQLITE_NOTADB. SQLITE_CORRUPT would keep a transaction from
/// further writes, and SQLITE_IOERR would roll it back; undamaged rows could then not be copied.
/// Threads  any
[[nodiscard]] const char* checked_files();

/// Whether a database has checksums, by its header; false for a file that is not a database. Precondition: no
/// thread of this process has it open, because closing a file releases all POSIX locks of the process on it,
/// also SQLite's.
[[nodiscard]] bool has_page_checksums(const std::filesystem::path& database);

/// Page size and reserved bytes in the header of a database.
struct PageLayout {
  std::size_t page_bytes{};  // 0: not a valid page size
  bool has_checksums{};
};
inline constexpr std::size_t header_bytes = 100;
[[nodiscard]] PageLayout layout_of_pages(std::span<const std::byte> header);

/// Whether a page matches its checksum.
[[nodiscard]] bool is_whole_page(std::span<const std::byte> page);

/// Reads bytes of a file that SQLite has open, without verifying checksums; fewer at the end of the file.
/// Errors   Failure when the file cannot be read, or was not opened with checked_files
[[nodiscard]] std::vector<std::byte> bytes_in_file(sqlite3* database, std::uint64_t offset,
                                                   std::size_t bytes);

}  // namespace floeplan::sql::sqlite

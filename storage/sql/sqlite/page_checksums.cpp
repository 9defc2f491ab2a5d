#include "storage/sql/sqlite/page_checksums.hpp"

#include <sqlite3.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <new>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql::sqlite {
namespace {

constexpr std::size_t page_size_at = 16;  // two bytes, big-endian; 1 means 65536
constexpr std::size_t reserved_at = 20;
constexpr std::size_t smallest_page = 512;
constexpr std::size_t largest_page = 65536;

using Sum = std::array<std::byte, checksum_bytes>;

Sum sum_of(std::span<const std::byte> page) {
  const std::uint64_t hash = XXH3_64bits(page.data(), page.size() - checksum_bytes);
  Sum sum{};
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = static_cast<std::byte>(hash >> (8 * i));
  return sum;
}

bool is_whole(std::span<const std::byte> page) {
  return std::ranges::equal(sum_of(page), page.last(checksum_bytes));
}

/// Whether an access is of a whole page. SQLite accesses whole pages, except for the header and the counter
/// in it.
bool is_page(std::size_t bytes, sqlite3_int64 offset) {
  return bytes >= smallest_page && bytes <= largest_page && std::has_single_bit(bytes) &&
         offset % static_cast<sqlite3_int64>(bytes) == 0;
}

bool has_header(std::size_t bytes, sqlite3_int64 offset) { return offset == 0 && bytes >= header_bytes; }

bool reserves_sums(std::span<const std::byte> header) {
  return std::to_integer<int>(header[reserved_at]) == checksum_bytes;
}

std::size_t page_size_of(std::span<const std::byte> header) {
  const auto size = std::to_integer<std::size_t>(header[page_size_at]) << 8U |
                    std::to_integer<std::size_t>(header[page_size_at + 1]);
  return size == 1 ? largest_page : size;
}

/// An open database file; the object of SQLite's own file follows it in memory.
struct CheckedFile {
  sqlite3_file base;
  bool has_sums;

  [[nodiscard]] sqlite3_file* own() {
    return std::launder(
        reinterpret_cast<sqlite3_file*>(reinterpret_cast<std::byte*>(this) + sizeof(CheckedFile)));
  }
};

CheckedFile& checked(sqlite3_file* file) { return *reinterpret_cast<CheckedFile*>(file); }
sqlite3_file* own(sqlite3_file* file) { return checked(file).own(); }

int close_file(sqlite3_file* file) { return own(file)->pMethods->xClose(own(file)); }

int read_checked(sqlite3_file* file, void* buffer, int bytes, sqlite3_int64 offset) {
  CheckedFile& self = checked(file);
  const int result = self.own()->pMethods->xRead(self.own(), buffer, bytes, offset);
  if (result != SQLITE_OK) return result;
  const std::span data{static_cast<const std::byte*>(buffer), static_cast<std::size_t>(bytes)};
  if (has_header(data.size(), offset)) self.has_sums = reserves_sums(data);
  return self.has_sums && is_page(data.size(), offset) && !is_whole(data) ? SQLITE_NOTADB : SQLITE_OK;
}

int write_checked(sqlite3_file* file, const void* buffer, int bytes, sqlite3_int64 offset) {
  CheckedFile& self = checked(file);
  const std::span data{static_cast<const std::byte*>(buffer), static_cast<std::size_t>(bytes)};
  if (has_header(data.size(), offset)) self.has_sums = reserves_sums(data);
  if (!self.has_sums || !is_page(data.size(), offset))
    return self.own()->pMethods->xWrite(self.own(), buffer, bytes, offset);
  std::array<std::byte, largest_page> page;  // not initialised, because only the part that is filled is used
  std::ranges::copy(data, page.begin());
  std::ranges::copy(sum_of(data), page.begin() + bytes - checksum_bytes);
  return self.own()->pMethods->xWrite(self.own(), page.data(), bytes, offset);
}

int truncate_file(sqlite3_file* file, sqlite3_int64 size) {
  return own(file)->pMethods->xTruncate(own(file), size);
}
int sync_file(sqlite3_file* file, int flags) { return own(file)->pMethods->xSync(own(file), flags); }
int size_of_file(sqlite3_file* file, sqlite3_int64* size) {
  return own(file)->pMethods->xFileSize(own(file), size);
}
int lock_file(sqlite3_file* file, int level) { return own(file)->pMethods->xLock(own(file), level); }
int unlock_file(sqlite3_file* file, int level) { return own(file)->pMethods->xUnlock(own(file), level); }
int is_locked(sqlite3_file* file, int* held) {
  return own(file)->pMethods->xCheckReservedLock(own(file), held);
}
int control_file(sqlite3_file* file, int what, void* argument) {
  return own(file)->pMethods->xFileControl(own(file), what, argument);
}
int sector_size(sqlite3_file* file) { return own(file)->pMethods->xSectorSize(own(file)); }
int characteristics(sqlite3_file* file) { return own(file)->pMethods->xDeviceCharacteristics(own(file)); }
int shm_map(sqlite3_file* file, int region, int size, int extend, void volatile** memory) {
  return own(file)->pMethods->xShmMap(own(file), region, size, extend, memory);
}
int shm_lock(sqlite3_file* file, int offset, int count, int flags) {
  return own(file)->pMethods->xShmLock(own(file), offset, count, flags);
}
void shm_barrier(sqlite3_file* file) { own(file)->pMethods->xShmBarrier(own(file)); }
int shm_unmap(sqlite3_file* file, int remove) { return own(file)->pMethods->xShmUnmap(own(file), remove); }

/// Version 2, without xFetch: pages mapped into memory would not be verified.
constexpr sqlite3_io_methods methods{.iVersion = 2,
                                     .xClose = close_file,
                                     .xRead = read_checked,
                                     .xWrite = write_checked,
                                     .xTruncate = truncate_file,
                                     .xSync = sync_file,
                                     .xFileSize = size_of_file,
                                     .xLock = lock_file,
                                     .xUnlock = unlock_file,
                                     .xCheckReservedLock = is_locked,
                                     .xFileControl = control_file,
                                     .xSectorSize = sector_size,
                                     .xDeviceCharacteristics = characteristics,
                                     .xShmMap = shm_map,
                                     .xShmLock = shm_lock,
                                     .xShmBarrier = shm_barrier,
                                     .xShmUnmap = shm_unmap,
                                     .xFetch = nullptr,
                                     .xUnfetch = nullptr};

sqlite3_vfs* usual(sqlite3_vfs* vfs) { return static_cast<sqlite3_vfs*>(vfs->pAppData); }

int open_checked(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out_flags) {
  if ((flags & SQLITE_OPEN_MAIN_DB) == 0) return usual(vfs)->xOpen(usual(vfs), name, file, flags, out_flags);
  auto* self = new (static_cast<void*>(file)) CheckedFile{{nullptr}, false};
  std::memset(static_cast<void*>(self->own()), 0, static_cast<std::size_t>(usual(vfs)->szOsFile));
  const int result = usual(vfs)->xOpen(usual(vfs), name, self->own(), flags, out_flags);
  if (result == SQLITE_OK) self->base.pMethods = &methods;
  return result;
}

/// SQLite's usual file system, except for the opening of files.
struct CheckedFiles {
  sqlite3_vfs vfs;

  CheckedFiles() : vfs{*sqlite3_vfs_find(nullptr)} {
    vfs.pNext = nullptr;
    vfs.pAppData = sqlite3_vfs_find(nullptr);
    vfs.szOsFile += static_cast<int>(sizeof(CheckedFile));
    vfs.zName = "floeplan";
    vfs.xOpen = open_checked;
    sqlite3_vfs_register(&vfs, 0);
  }
};

CheckedFile& file_of(sqlite3* database) {
  sqlite3_file* file = nullptr;
  const int result =
      sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, static_cast<void*>(&file));
  if (result != SQLITE_OK || file == nullptr || file->pMethods != &methods)
    throw Failure{messages::store_text<"database-without-checksums">()};
  return checked(file);
}

}  // namespace

const char* checked_files() {
  static CheckedFiles files;
  return files.vfs.zName;
}

bool has_page_checksums(const std::filesystem::path& database) {
  std::ifstream in{database, std::ios::binary};
  std::array<std::byte, header_bytes> header{};
  in.read(reinterpret_cast<char*>(header.data()), header.size());
  return in.gcount() == static_cast<std::streamsize>(header.size()) && reserves_sums(header);
}

PageLayout layout_of_pages(std::span<const std::byte> header) {
  if (header.size() < header_bytes) return {};
  const std::size_t size = page_size_of(header);
  return {.page_bytes = is_page(size, 0) ? size : 0, .has_checksums = reserves_sums(header)};
}

bool is_whole_page(std::span<const std::byte> page) { return is_whole(page); }

std::vector<std::byte> bytes_in_file(sqlite3* database, std::uint64_t offset, std::size_t bytes) {
  sqlite3_file* const file = file_of(database).own();
  sqlite3_int64 size = 0;
  if (file->pMethods->xFileSize(file, &size) != SQLITE_OK) size = 0;
  const auto end = static_cast<std::uint64_t>(size);
  std::vector<std::byte> data(offset < end ? std::min<std::uint64_t>(bytes, end - offset) : 0);
  if (data.empty()) return data;
  const int result = file->pMethods->xRead(file, data.data(), static_cast<int>(data.size()),
                                           static_cast<sqlite3_int64>(offset));
  if (result == SQLITE_IOERR_SHORT_READ) data.clear();  // the file was truncated at this moment
  if (result != SQLITE_OK && result != SQLITE_IOERR_SHORT_READ)
    throw Failure{messages::store_text<"database-not-read">(), Trouble::not_writable};
  return data;
}

}  // namespace floeplan::sql::sqlite

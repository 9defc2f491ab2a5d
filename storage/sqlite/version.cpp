#include "storage/sqlite/version.hpp"

#include <SQLiteCpp/Database.h>
#include <sqlite3.h>

#include <algorithm>
#include <optional>

#include "storage/sqlite/failure.hpp"
#include "storage/sqlite/statement.hpp"

namespace floeplan::sqlite {
namespace {

using LogHeader = decltype(Version::log_header);

/// Nothing where there is no log, or its index is not there yet. A header that is being written as it is read is like
/// none that is whole: the number of the change in it has no second.
std::optional<LogHeader> log_header(Connection& db) {
  if (!db.has_write_ahead_log()) return std::nullopt;
  sqlite3_file* file = nullptr;
  sqlite3_file_control(db.handle().getHandle(), "main", SQLITE_FCNTL_FILE_POINTER, static_cast<void*>(&file));
  constexpr int index_page_bytes = 32'768;  // sqlite.org/walformat.html, 2.2
  volatile void* index = nullptr;
  const int status = file->pMethods->xShmMap(file, 0, index_page_bytes, 0, &index);
  if (status != SQLITE_OK || index == nullptr) return std::nullopt;
  LogHeader header{};
  std::copy_n(static_cast<const volatile std::uint32_t*>(index), header.size(), header.begin());
  return header;
}

}  // namespace

Version version_of(Connection& db) {
  if (const auto header = log_header(db)) return {.log_header = *header};
  Statement query{db, "PRAGMA data_version"};
  if (!query.step()) throw Failure{"the database does not tell its version"};
  return {.of_others = query.integer(0), .own_rows = sqlite3_total_changes64(db.handle().getHandle())};
}

}  // namespace floeplan::sqlite

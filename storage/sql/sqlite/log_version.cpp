#include "storage/sql/sqlite/log_version.hpp"

#include <sqlite3.h>

#include <algorithm>

namespace floeplan::sql::sqlite {

std::optional<Version> log_version(sqlite3* database) {
  sqlite3_file* file = nullptr;
  sqlite3_file_control(database, "main", SQLITE_FCNTL_FILE_POINTER, static_cast<void*>(&file));
  constexpr int index_page_bytes = 32'768;  // sqlite.org/walformat.html, 2.2
  volatile void* index = nullptr;
  const int status = file->pMethods->xShmMap(file, 0, index_page_bytes, 0, &index);
  if (status != SQLITE_OK || index == nullptr) return std::nullopt;
  Version version;
  std::copy_n(static_cast<const volatile std::uint32_t*>(index), version.numbers.size(),
              version.numbers.begin());
  return version;
}

}  // namespace floeplan::sql::sqlite

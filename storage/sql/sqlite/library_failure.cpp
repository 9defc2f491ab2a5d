#include "storage/sql/sqlite/library_failure.hpp"

#include <sqlite3.h>

#include "engine/messages/store_messages.hpp"

namespace floeplan::sql::sqlite {

Failure failure_of(const SQLite::Exception& cause, const std::string& file) {
  const std::string detail = cause.what();
  switch (cause.getErrorCode() & 0xff) {  // the primary code; the rest is detail
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
      return Failure{messages::store_text<"database-damaged">(file, detail), Trouble::damaged};
    case SQLITE_FULL: return Failure{messages::store_text<"disk-full">(file, detail), Trouble::disk_full};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return Failure{messages::store_text<"database-locked">(file, detail), Trouble::held_by_another};
    case SQLITE_IOERR:
      return Failure{messages::store_text<"disk-failed">(file, detail), Trouble::not_writable};
    case SQLITE_READONLY:
      return Failure{messages::store_text<"database-read-only">(file, detail), Trouble::not_writable};
    case SQLITE_CANTOPEN:
      return Failure{messages::store_text<"database-not-opened">(file, detail), Trouble::not_writable};
    default: return Failure{messages::store_text<"database-failed">(file, detail)};
  }
}

}  // namespace floeplan::sql::sqlite

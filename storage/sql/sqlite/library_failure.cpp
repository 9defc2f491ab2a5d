#include "storage/sql/sqlite/library_failure.hpp"

#include <sqlite3.h>

namespace floeplan::sql::sqlite {

Failure failure_of(const SQLite::Exception& cause, const std::string& file) {
  const std::string database = "the database " + file;
  const std::string detail = std::string{" ("} + cause.what() + ")";
  switch (cause.getErrorCode() & 0xff) {  // the primary code; the rest is detail
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
      return Failure{database + " is damaged or not a Floeplan store" + detail +
                         "; floeplan verify says what of it is damaged, floeplan repair saves the rest, and "
                         "floeplan restore puts "
                         "back a backup",
                     Trouble::damaged};
    case SQLITE_FULL:
      return Failure{database + " cannot grow: the disk is full" + detail, Trouble::disk_full};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return Failure{database + " was held by another program for too long" + detail,
                     Trouble::held_by_another};
    case SQLITE_IOERR:
      return Failure{database + " cannot be read or written" + detail + "; look at the disk",
                     Trouble::not_writable};
    case SQLITE_READONLY:
      return Failure{database + " cannot be written" + detail + "; check its permissions",
                     Trouble::not_writable};
    case SQLITE_CANTOPEN:
      return Failure{database + " cannot be opened" + detail + "; check its permissions",
                     Trouble::not_writable};
    default: return Failure{database + " failed" + detail};
  }
}

}  // namespace floeplan::sql::sqlite

#include "storage/sqlite/version.hpp"

#include <SQLiteCpp/Database.h>
#include <sqlite3.h>

#include "storage/sqlite/failure.hpp"
#include "storage/sqlite/statement.hpp"

namespace floeplan::sqlite {

Version version_of(Connection& db) {
  Statement query{db, "PRAGMA data_version"};
  if (!query.step()) throw Failure{"the database does not tell its version"};
  return {query.integer(0), sqlite3_total_changes64(db.handle().getHandle())};
}

}  // namespace floeplan::sqlite

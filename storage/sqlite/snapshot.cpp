#include "storage/sqlite/snapshot.hpp"

#include <SQLiteCpp/Database.h>
#include <sqlite3.h>

#include <stdexcept>

#include "storage/sqlite/statement.hpp"

namespace floeplan::sqlite {

Snapshot::Snapshot(Connection& db) : db_{db}, began_{sqlite3_get_autocommit(db.handle().getHandle()) != 0} {
  if (began_) execute(db_, "BEGIN DEFERRED");
}

Snapshot::~Snapshot() {
  if (!began_) return;
  try {
    execute(db_, "ROLLBACK");
    // NOLINTNEXTLINE(bugprone-empty-catch): after a failed read it has ended already
  } catch (const std::runtime_error&) {
  }
}

}  // namespace floeplan::sqlite

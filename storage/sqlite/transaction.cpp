#include "storage/sqlite/transaction.hpp"

#include <SQLiteCpp/Database.h>
#include <sqlite3.h>

#include <stdexcept>

#include "storage/sqlite/statement.hpp"

namespace floeplan::sqlite {

// Savepoints may share a name: it always means the innermost.
Transaction::Transaction(Connection& db)
    : db_{db}, outermost_{sqlite3_get_autocommit(db.handle().getHandle()) != 0} {
  execute(db_, outermost_ ? "BEGIN IMMEDIATE" : "SAVEPOINT nested");
}

Transaction::~Transaction() {
  if (finished_) return;
  try {
    execute(db_, outermost_ ? "ROLLBACK" : "ROLLBACK TO nested; RELEASE nested");
    // NOLINTNEXTLINE(bugprone-empty-catch): after a full disk it was undone already
  } catch (const std::runtime_error&) {
  }
}

void Transaction::commit() {
  if (finished_) throw std::logic_error{"the transaction is finished"};
  execute(db_, outermost_ ? "COMMIT" : "RELEASE nested");
  finished_ = true;
}

}  // namespace floeplan::sqlite

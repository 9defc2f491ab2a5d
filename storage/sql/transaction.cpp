#include "storage/sql/transaction.hpp"

#include <stdexcept>

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

// Savepoints may share a name: it always means the innermost.
Transaction::Transaction(Connection& db, WriteTurn turn)
    : db_{db}, outermost_{!db.driver().is_in_transaction()} {
  if (outermost_)
    db_.driver().begin_writing(turn);
  else
    execute(db_, "SAVEPOINT nested");
}

Transaction::~Transaction() {
  if (finished_) return;
  try {
    if (outermost_)
      db_.driver().roll_back();
    else
      execute(db_, "ROLLBACK TO nested; RELEASE nested");
    // NOLINTNEXTLINE(bugprone-empty-catch): a full disk has already rolled it back
  } catch (const std::runtime_error&) {
  }
}

void Transaction::commit() {
  if (finished_) throw std::logic_error{"the transaction is finished"};
  if (outermost_)
    db_.driver().commit();
  else
    execute(db_, "RELEASE nested");
  finished_ = true;
}

}  // namespace floeplan::sql

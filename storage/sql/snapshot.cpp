#include "storage/sql/snapshot.hpp"

#include <stdexcept>

namespace floeplan::sql {

Snapshot::Snapshot(Connection& db) : db_{db}, began_{!db.driver().is_in_transaction()} {
  if (began_) db_.driver().begin_reading();
}

Snapshot::~Snapshot() {
  if (!began_) return;
  try {
    db_.driver().roll_back();
    // NOLINTNEXTLINE(bugprone-empty-catch): after a failed read the transaction has already ended
  } catch (const std::runtime_error&) {
  }
}

}  // namespace floeplan::sql

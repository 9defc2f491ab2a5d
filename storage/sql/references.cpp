#include "storage/sql/references.hpp"

#include <stdexcept>

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

void defer_references(Connection& db) {
  execute(db,
          db.engine() == Engine::server ? "SET CONSTRAINTS ALL DEFERRED" : "PRAGMA defer_foreign_keys = ON");
}

WithoutReferences::WithoutReferences(Connection& db) : db_{db} { execute(db_, "PRAGMA foreign_keys = OFF"); }

WithoutReferences::~WithoutReferences() {
  try {
    execute(db_, "PRAGMA foreign_keys = ON");
    // NOLINTNEXTLINE(bugprone-empty-catch): a connection on which this fails is not used any more
  } catch (const std::runtime_error&) {
  }
}

bool has_broken_references(Connection& db) {
  Statement check{db, "PRAGMA foreign_key_check"};
  return check.step();
}

}  // namespace floeplan::sql

#pragma once

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// Until the end of the transaction, rows may refer to rows that do not exist yet.
void defer_references(Connection& db);

/// While an object of this class lives, references are not enforced. With references, dropping a table would
/// also delete the rows that refer to it.
/// Edges    must be created and destroyed outside of transactions
class WithoutReferences {
 public:
  explicit WithoutReferences(Connection& db);
  WithoutReferences(const WithoutReferences&) = delete;
  WithoutReferences& operator=(const WithoutReferences&) = delete;
  ~WithoutReferences();

 private:
  Connection& db_;  // borrowed
};

/// Whether any row refers to a row that does not exist. Reads all tables.
[[nodiscard]] bool has_broken_references(Connection& db);

}  // namespace floeplan::sql

#pragma once

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// From here to the end of the transaction rows may refer to others that are not there yet.
void defer_references(Connection& db);

/// While it lives, references are not enforced: to drop a table that others refer to would empty them, too.
/// Edges    it begins and ends outside of transactions
class WithoutReferences {
 public:
  explicit WithoutReferences(Connection& db);
  WithoutReferences(const WithoutReferences&) = delete;
  WithoutReferences& operator=(const WithoutReferences&) = delete;
  ~WithoutReferences();

 private:
  Connection& db_;  // borrowed
};

/// Whether any row refers to one that is not there. Reads all tables.
[[nodiscard]] bool has_broken_references(Connection& db);

}  // namespace floeplan::sql

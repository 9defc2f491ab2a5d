#pragma once

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// While an object of this class lives, everything read through the connection is from the same state,
/// whatever others write. Nobody has to wait.
/// Edges    no effect inside a transaction, which already reads one state
class Snapshot {
 public:
  explicit Snapshot(Connection& db);
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;
  ~Snapshot();

 private:
  Connection& db_;  // borrowed
  bool began_;
};

}  // namespace floeplan::sql

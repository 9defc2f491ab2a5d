#pragma once

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// While it lives, everything read through the connection is from one moment, whatever others write. Nobody
/// waits for it.
/// Edges    inside a transaction it adds nothing: that is one moment already
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

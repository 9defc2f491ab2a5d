#pragma once

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// A transaction that is undone unless it was committed. It takes the right to write at once, so that it
/// never fails halfway because somebody else wrote first. Inside another one it is a savepoint: undone
/// alone, on disk with the outer.
/// Errors   Failure when the database is held for longer than the busy timeout; std::logic_error for a
///          second commit
class Transaction {
 public:
  explicit Transaction(Connection& db, WriteTurn turn = WriteTurn::alone);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  /// After it returns, an outermost transaction is on disk.
  void commit();
  [[nodiscard]] bool is_finished() const { return finished_; }

 private:
  Connection& db_;  // borrowed
  bool outermost_;
  bool finished_{false};
};

}  // namespace floeplan::sql

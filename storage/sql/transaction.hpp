#pragma once

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// A transaction that is rolled back unless it is committed. It takes the write lock at once, so that it
/// cannot fail later because another connection has written. Inside another transaction it is a savepoint,
/// which can be rolled back alone and is on disk after the outer commit.
/// Errors   Failure when the database is locked for longer than the busy timeout; std::logic_error for a
///          second commit
class Transaction {
 public:
  explicit Transaction(Connection& db, WriteTurn turn = WriteTurn::alone);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  /// Commits. When it returns, an outermost transaction is on disk.
  void commit();
  [[nodiscard]] bool is_finished() const { return finished_; }

 private:
  Connection& db_;  // borrowed
  bool outermost_;
  bool finished_{false};
};

}  // namespace floeplan::sql

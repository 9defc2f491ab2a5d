#include "storage/sql/shared/use_of_store.hpp"

#include "storage/sql/statement.hpp"

namespace floeplan::sql {
namespace {

/// The lock of one store: the first number is ours ("FLOU"), the second the store's schema.
constexpr const char* lock_of_users = "(1179406165, hashtext(current_schema()))";

}  // namespace

void use_store(Connection& db) {
  if (is_shared(db))
    db.driver().in_each_session(std::string{"SELECT pg_advisory_lock_shared"} + lock_of_users);
}

bool take_store_alone(Connection& db) {
  if (!is_shared(db)) return true;
  Statement lock{db, std::string{"SELECT pg_try_advisory_lock"} + lock_of_users};
  return lock.step() && lock.integer(0) != 0;
}

}  // namespace floeplan::sql

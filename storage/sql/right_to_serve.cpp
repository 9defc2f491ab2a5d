#include "storage/sql/right_to_serve.hpp"

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

bool take_right_to_serve(Connection& server) {
  // The first number is ours ("FLOS"), the second the store's schema.
  Statement lock{server, "SELECT pg_try_advisory_lock(1179406163, hashtext(current_schema()))"};
  return lock.step() && lock.integer(0) != 0;
}

}  // namespace floeplan::sql

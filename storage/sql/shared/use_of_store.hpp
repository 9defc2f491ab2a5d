#pragma once

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// Marks a shared store as used by a node for as long as the connection lives. Waits for one who has it alone.
/// Errors   Failure when that lasts longer than the busy timeout
void use_store(Connection& db);

/// Takes a shared store for this connection alone; nodes cannot begin to use it meanwhile.
/// Returns  false where a node uses it
[[nodiscard]] bool take_store_alone(Connection& db);

}  // namespace floeplan::sql

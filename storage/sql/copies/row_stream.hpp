#pragma once

#include <functional>
#include <string>

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

/// Calls `take` for each row of a query without parameters. Tables may have any size, because a database
/// server sends a few rows at a time. A `Statement` would take all of them at once.
/// Precondition  a Snapshot or a Transaction of the connection
/// `name`        of the stream, a word that no other stream of the connection has at the same time
void for_each_row(Connection& db, const std::string& name, const std::string& query,
                  const std::function<void(const Row&)>& take);

}  // namespace floeplan::sql

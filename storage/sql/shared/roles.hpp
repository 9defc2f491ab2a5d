#pragma once

#include <string>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// Lets a role of the database server work on a store: read and write all rows, but make or change no table.
/// Errors   Failure for an unknown role, or when the user of the connection does not own the store
void admit_role(Connection& db, const std::string& role);

}  // namespace floeplan::sql

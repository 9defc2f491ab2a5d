#pragma once

#include <cstdint>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// The number of the schema of the database's tables; 0 for a new database.
[[nodiscard]] std::int64_t schema_number(Connection& db);

/// Stores the number of the schema, and marks the database as Floeplan's.
void set_schema_number(Connection& db, std::int64_t number);

}  // namespace floeplan::sql

#pragma once

#include <cstdint>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// The number of the schema of the database's tables; 0 for a new database.
[[nodiscard]] std::int64_t schema_number(Connection& db);

/// The least schema that a program must know to work on this database although its own schema is newer. Stores in
/// files state none; then it is the schema's own number.
[[nodiscard]] std::int64_t schema_usable_from(Connection& db);

/// Stores the number of the schema, and marks the database as Floeplan's. Only a server's database keeps
/// `usable_from`, because nodes of two versions work there at the same time while a new one is rolled out.
void set_schema_number(Connection& db, std::int64_t number, std::int64_t usable_from);

}  // namespace floeplan::sql

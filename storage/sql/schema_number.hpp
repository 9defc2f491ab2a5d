#pragma once

#include <cstdint>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// The number of the schema that the database's tables follow; 0 of a new database.
[[nodiscard]] std::int64_t schema_number(Connection& db);

/// Says which schema the tables follow, and that the database is Floeplan's.
void set_schema_number(Connection& db, std::int64_t number);

}  // namespace floeplan::sql

#pragma once

#include <cstdint>
#include <span>

#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Scripts that lead from one schema to the next. A released script is never changed; new ones go to the end.
/// Foreign keys are not enforced while a script runs, so that a table can be rebuilt; they are checked at the end.
/// Longitudes in the box tables run eastwards from [-180, 180), so a box across the antimeridian ends beyond
/// 180.
[[nodiscard]] std::span<const char* const> schema_scripts();

/// The schema of a store that a database server keeps: the same tables and columns as the newest of `schema_scripts`.
/// Triggers, keys and indices are in the server's own words.
[[nodiscard]] const char* server_schema();

/// What this program writes; older ones are brought to it, newer ones refused.
[[nodiscard]] std::int64_t newest_schema();

/// From this schema on the pages of a database have checksums.
inline constexpr std::int64_t first_schema_with_checksums = 12;

/// Errors  std::runtime_error for a schema that this program does not know yet
void refuse_newer_schema(std::int64_t schema);

/// Brings a database of any older schema, and an empty one, to the newest in one transaction.
/// Errors  std::runtime_error for a newer one, and where rows refer to others that are not there
void bring_to_newest_schema(sql::Connection& db);

}  // namespace floeplan::repository

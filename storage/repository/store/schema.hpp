#pragma once

#include <cstdint>

#include "storage/sql/connection.hpp"

namespace floeplan::repository {

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

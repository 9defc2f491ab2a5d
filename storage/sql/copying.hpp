#pragma once

#include <filesystem>
#include <string>

#include "storage/sql/connection.hpp"

/// Writing a database anew from an attached one, `schema`: its tables, rows (which callers copy), indices, numbers, as one
/// file without a log, not yet flushed to the disk.
/// Errors  Failure when either fails, also where damage hides the schema
namespace floeplan::sql {

/// An empty database in `folder` for rows that are copied as they are. Nobody misses it after a kill, so nothing waits for
/// the disk; references are not enforced.
[[nodiscard]] Connection open_copy(const std::filesystem::path& folder);

/// All tables and indices of boxes, without rows.
void make_tables_as_in(Connection& db, const std::string& schema);

/// All indices and triggers.
void make_indices_as_in(Connection& db, const std::string& schema);

/// Numbers that rows had once are not given again. They follow from the rows that were copied where damage hides them.
void take_highest_rows_from(Connection& db, const std::string& schema);

/// The number of the schema, and whose the database is.
void take_schema_number_from(Connection& db, const std::string& schema);

/// Makes it one file.
void finish_copy(Connection& db);

}  // namespace floeplan::sql

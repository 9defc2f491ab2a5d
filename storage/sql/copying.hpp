#pragma once

#include <filesystem>
#include <string>

#include "storage/sql/connection.hpp"

/// Functions that copy an attached database, `schema`, to a new one: tables, indices and numbers; callers
/// copy the rows. The result is a single file without a log, not yet flushed to the disk.
/// Errors  Failure when either database fails, also when damage makes the schema unreadable
namespace floeplan::sql {

/// Creates an empty database in `folder` for copied rows. It does not wait for the disk, because it can be
/// made again after a kill; references are not enforced.
[[nodiscard]] Connection open_copy(const std::filesystem::path& folder);

/// Creates all tables and R*Trees, without rows.
void make_tables_as_in(Connection& db, const std::string& schema);

/// Creates all indices and triggers.
void make_indices_as_in(Connection& db, const std::string& schema);

/// Takes over the highest row numbers, so that numbers are not reused. If damage hides them, the copied rows
/// give them.
void take_highest_rows_from(Connection& db, const std::string& schema);

/// Takes over the number of the schema and the application id.
void take_schema_number_from(Connection& db, const std::string& schema);

/// Makes the copy a single file, without a log.
void finish_copy(Connection& db);

}  // namespace floeplan::sql

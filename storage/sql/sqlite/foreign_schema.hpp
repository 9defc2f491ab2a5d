#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace floeplan::sql::sqlite {

/// From now on every connection of this process, also of libraries, refuses to run functions and modules of other
/// libraries from what a database's schema says (views, triggers, computed columns), and keeps the tables of its own
/// bookkeeping from being written.
/// Source   sqlite.org/c3ref/c_dbconfig_defensive.html: DEFENSIVE, TRUSTED_SCHEMA
void distrust_schemas();

/// What in the schema of somebody else's database could run code or reach other files when it is read: views, computed
/// columns, virtual tables but R*Trees. Tables, indexes and triggers (which only writing fires) are what GDAL and QGIS
/// write. The database is opened for reading alone, as one that nobody changes, and nothing of it is run.
/// Returns  a few words for a person; nothing: it has no such thing
/// Errors   Failure when the file is damaged or no database
[[nodiscard]] std::optional<std::string> active_part_of(const std::filesystem::path& file);

/// The same of one statement of a schema.
[[nodiscard]] std::optional<std::string> active_part_of_statement(const std::string& sql);

}  // namespace floeplan::sql::sqlite

#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace floeplan::sql::sqlite {

/// From now on, no connection of this process, also of libraries, runs functions or modules of other
/// libraries because a database's schema (views, triggers, computed columns) calls them, and none writes
/// SQLite's internal tables directly.
/// Source   sqlite.org/c3ref/c_dbconfig_defensive.html: DEFENSIVE, TRUSTED_SCHEMA
void distrust_schemas();

/// Looks for parts of another program's database that could run code or reach other files when it is read:
/// views, computed columns, virtual tables other than R*Trees. Tables, indexes and triggers (which run only
/// on writing) are allowed; GDAL and QGIS write them. The database is opened read-only and immutable, and
/// none of its code is run.
/// Returns  the part in a few words for the user; nullopt: there is none
/// Errors   Failure when the file is damaged or not a database
[[nodiscard]] std::optional<std::string> active_part_of(const std::filesystem::path& file);

/// The same for one statement of a schema.
[[nodiscard]] std::optional<std::string> active_part_of_statement(const std::string& sql);

}  // namespace floeplan::sql::sqlite

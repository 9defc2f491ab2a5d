#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// Writes the whole database in its present state to a new file; others can read and write meanwhile. The
/// file is complete and on disk, or does not exist.
/// Errors   Failure when the file exists, cannot be written, or fails the check afterwards
void back_up(Connection& db, const std::filesystem::path& file);

/// Moves content of the write-ahead log to the database, as far as this makes nobody wait.
void shorten_log(Connection& db);

/// Whether the pages of an open database have checksums.
[[nodiscard]] bool has_page_checksums(Connection& db);

/// Numbers of the pages, from 1, whose bytes in the file have changed. Others may read and write the database
/// meanwhile. Only page 1 if the header says that there are no checksums, because nothing is then known about
/// the others.
/// Errors   Failure when the file cannot be read
[[nodiscard]] std::vector<std::uint32_t> damaged_pages(Connection& db);

/// The first inconsistency of tables and indices, in SQLite's words; empty if there is none. Reads the whole
/// database.
[[nodiscard]] std::string damage_of_structure(Connection& db);

}  // namespace floeplan::sql

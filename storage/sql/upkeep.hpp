#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// Writes the whole database, as it stands at one moment, into a new file; others go on reading and writing meanwhile.
/// The file is there complete and on disk, or not at all.
/// Errors   Failure when the file exists, cannot be written, or does not come out sound
void back_up(Connection& db, const std::filesystem::path& file);

/// Moves what the database's log holds into the database, as far as nobody has to wait for it.
void shorten_log(Connection& db);

/// Whether the pages of an open database end with checksums.
[[nodiscard]] bool has_page_checksums(Connection& db);

/// Numbers of the pages, from 1, whose bytes in the file are not those that were written. Others may read and write the
/// database meanwhile. Of a file whose header reserves no bytes for checksums the first: nothing is known of the rest.
/// Errors   Failure when the file cannot be read
[[nodiscard]] std::vector<std::uint32_t> damaged_pages(Connection& db);

/// The first thing that is wrong with how tables and indices hang together, in the engine's words; empty when nothing is.
/// Reads all of the database.
[[nodiscard]] std::string damage_of_structure(Connection& db);

}  // namespace floeplan::sql

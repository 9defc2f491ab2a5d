#pragma once

#include <cstdint>
#include <vector>

struct sqlite3;

namespace floeplan::sql::sqlite {

/// Whether the pages of an open database end with checksums.
[[nodiscard]] bool has_page_checksums(sqlite3* database);

/// Numbers of the pages, from 1, whose bytes in the file are not those that were written. Others may read and write the
/// database meanwhile. Of a file whose header reserves no bytes for checksums the first: nothing is known of the rest.
/// Errors   Failure when the file cannot be read
[[nodiscard]] std::vector<std::uint32_t> damaged_pages(sqlite3* database);

}  // namespace floeplan::sql::sqlite

#pragma once

#include <cstdint>
#include <vector>

#include "storage/sqlite/connection.hpp"

namespace floeplan::sqlite {

/// Whether the pages of an open database end with checksums.
[[nodiscard]] bool has_page_checksums(Connection& db);

/// Numbers of the pages, from 1, whose bytes in the file are not those that were written. Others may read and write the
/// database meanwhile. Of a file whose header reserves no bytes for checksums the first: nothing is known of the rest.
/// Errors   Failure when the file cannot be read
[[nodiscard]] std::vector<std::uint32_t> damaged_pages(Connection& db);

}  // namespace floeplan::sqlite

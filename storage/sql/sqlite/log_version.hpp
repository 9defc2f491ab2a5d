#pragma once

#include <optional>

#include "storage/sql/driver/version.hpp"

struct sqlite3;

namespace floeplan::sql::sqlite {

/// The header of the write-ahead log's index, which every commit changes. It takes no lock, for it looks at memory that all
/// share. Nothing where the index is not there yet. A header that is being written as it is read is like none that is whole:
/// the number of the change in it has no second.
/// Edges    changes of tables themselves, and what is undone again, may count or not
/// Source   sqlite.org/walformat.html, 2.1
[[nodiscard]] std::optional<Version> log_version(sqlite3* database);

}  // namespace floeplan::sql::sqlite

#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <string>

#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql::sqlite {

/// Converts the library's exception to a Failure; `file` is the database's path.
[[nodiscard]] Failure failure_of(const SQLite::Exception& cause, const std::string& file);

/// Runs `work` and converts exceptions of the library to Failure.
template <class Work>
auto translated(const SQLite::Database& database, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, database.getFilename());
  }
}

}  // namespace floeplan::sql::sqlite

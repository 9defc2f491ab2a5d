#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <string>

#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql::sqlite {

/// The library's exception as ours; `file` is the database's path.
[[nodiscard]] Failure failure_of(const SQLite::Exception& cause, const std::string& file);

/// Whatever the library throws inside `work` leaves as a Failure.
template <class Work>
auto translated(const SQLite::Database& database, const Work& work) {
  try {
    return work();
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, database.getFilename());
  }
}

}  // namespace floeplan::sql::sqlite

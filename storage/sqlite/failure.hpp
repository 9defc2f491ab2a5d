#pragma once

#include <stdexcept>
#include <string>

namespace SQLite {
class Exception;
}

namespace floeplan::sqlite {

/// The database could not do what it was asked: damaged, full, locked for too long, or a constraint broken.
/// what() says which, and what to do, for a person.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The library's exception as ours; `file` is the database's path.
[[nodiscard]] Failure failure_of(const SQLite::Exception& cause, const std::string& file);

}  // namespace floeplan::sqlite

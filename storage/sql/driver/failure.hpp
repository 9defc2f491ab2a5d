#pragma once

#include <stdexcept>
#include <string>

namespace floeplan::sql {

/// What keeps a database from its work; `other` is also what a statement of ours does wrong.
enum class Trouble { damaged, disk_full, held_by_another, not_writable, other };

/// The database could not do what it was asked: damaged, full, locked for too long, or a constraint broken.
/// what() says which, and what to do, for a person.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& what, Trouble trouble = Trouble::other)
      : std::runtime_error{what}, trouble_{trouble} {}

  [[nodiscard]] Trouble trouble() const { return trouble_; }

 private:
  Trouble trouble_;
};

}  // namespace floeplan::sql

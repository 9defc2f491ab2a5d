#pragma once

#include <stdexcept>
#include <string>

namespace floeplan::sql {

/// Why a database operation failed; `other` includes errors in this program's statements.
enum class Trouble { damaged, disk_full, held_by_another, not_writable, other };

/// Thrown when a database operation fails: damage, full disk, locked for too long, or a violated constraint.
/// what() tells the user the reason and what to do.
class Failure : public std::runtime_error {
 public:
  explicit Failure(const std::string& what, Trouble trouble = Trouble::other)
      : std::runtime_error{what}, trouble_{trouble} {}

  [[nodiscard]] Trouble trouble() const { return trouble_; }

 private:
  Trouble trouble_;
};

}  // namespace floeplan::sql

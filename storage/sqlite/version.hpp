#pragma once

#include <array>
#include <cstdint>

#include "storage/sqlite/connection.hpp"

namespace floeplan::sqlite {

/// What a connection sees: while it has the same version, it reads the same. Versions of two connections say nothing of
/// each other.
struct Version {
  /// Of the write-ahead log's index; every commit changes it, whoever made it (sqlite.org/walformat.html, 2.1). Zeros
  /// where the numbers below say the same.
  std::array<std::uint32_t, 12> log_header{};
  std::int64_t of_others{};  // changes with everything that other connections commit
  std::int64_t own_rows{};   // that this connection has changed

  friend bool operator==(const Version&, const Version&) = default;
};

/// Costs next to nothing with a write-ahead log: it takes no lock then, for it looks at memory that all share.
/// Edges    changes of tables themselves, and what is undone again, may count or not
/// Errors   Failure when the database cannot be read
[[nodiscard]] Version version_of(Connection& db);

}  // namespace floeplan::sqlite

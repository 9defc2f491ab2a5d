#pragma once

#include <cstdint>

#include "storage/sqlite/connection.hpp"

namespace floeplan::sqlite {

/// What a connection sees: while it has the same version, it reads the same. Versions of two connections say nothing of
/// each other.
struct Version {
  std::int64_t
      of_others{};  // changes with everything that other connections commit, of this program or another
  std::int64_t own_rows{};  // that this connection has changed

  friend bool operator==(const Version&, const Version&) = default;
};

/// Costs a small part of any query.
/// Edges    changes of tables themselves, and what is undone again, may count or not
/// Errors   Failure when the database cannot be read
[[nodiscard]] Version version_of(Connection& db);

}  // namespace floeplan::sqlite

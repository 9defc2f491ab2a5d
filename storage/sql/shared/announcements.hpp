#pragma once

#include <chrono>
#include <string>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// Hears from here on what other sessions of the same store announce by this name. A store that is not shared announces
/// nothing.
void listen(Connection& db, const std::string& name);

/// Waits until something is announced, at most this long.
[[nodiscard]] inline Announced announced(Connection& db, std::chrono::milliseconds at_most) {
  return db.driver().announced(at_most);
}

}  // namespace floeplan::sql

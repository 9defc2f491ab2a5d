#pragma once

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// Takes the right to serve the store at a database server, which one session has at a time. It ends with the session.
/// Returns  whether it was free
[[nodiscard]] bool take_right_to_serve(Connection& server);

}  // namespace floeplan::sql
